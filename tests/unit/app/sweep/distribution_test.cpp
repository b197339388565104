#include "app/sweep/distribution.h"

#include <cmath>

#include <gtest/gtest.h>

namespace wuerfel::test {
namespace {

TEST(Distribution, LogarithmAndExponentialAreThoseOfTheLibraryToRounding) {
  for (double x = 1e-300; x < 1e300; x *= 1.37) {
    EXPECT_NEAR(portable_log(x), std::log(x), 5e-16 * std::abs(std::log(x)) + 1e-300) << x;
  }
  for (double x = 0.9; x < 1.1; x += 0.00037)
    EXPECT_NEAR(portable_log(x), std::log(x), 5e-16 * std::abs(std::log(x)) + 1e-300) << x;
  for (double x = -690.0; x < 690.0; x += 0.713)
    EXPECT_NEAR(portable_exp(x) / std::exp(x), 1.0, 5e-16) << x;
  EXPECT_EQ(portable_log(1.0), 0.0);
  EXPECT_EQ(portable_exp(0.0), 1.0);
}

// Python's statistics.NormalDist().inv_cdf.
TEST(Distribution, QuantilesOfTheNormalDistributionAreRight) {
  EXPECT_EQ(normal_quantile(0.5), 0.0);
  EXPECT_NEAR(normal_quantile(0.975), 1.9599639845400536, 1e-14);
  EXPECT_NEAR(normal_quantile(0.025), -1.9599639845400536, 1e-14);
  EXPECT_NEAR(normal_quantile(0.6), 0.2533471031357997, 1e-15);
  EXPECT_NEAR(normal_quantile(1e-10), -6.361340902404056, 1e-13);
  EXPECT_NEAR(normal_quantile(1e-300), -37.0471, 1e-4);
}

// The bits that every machine has to find; ids of cases depend on them.
TEST(Distribution, BitsAreRecorded) {
  EXPECT_EQ(value_at(Uniform{{-1.0, 2.0}}, 0.3), "-0.10000000000000009");
  EXPECT_EQ(value_at(Integers{2, 8}, 0.999999), "8");
  EXPECT_EQ(value_at(Integers{2, 8}, 1e-9), "2");
  EXPECT_EQ(value_at(OneOf{{"\"a\"", "[1,2]"}}, 0.6), "[1,2]");
  EXPECT_EQ(value_at(Normal{{1.0, 2.0}, NumberPair{0.0, 1.5}}, 0.9), "1.5");
}

TEST(Distribution, LogUniformKeepsItsEndsAndItsMiddle) {
  const Distribution draw = LogUniform{{0.01, 100.0}};
  EXPECT_NEAR(std::stod(value_at(draw, 0.5)), 1.0, 1e-15);
  EXPECT_GE(std::stod(value_at(draw, 1e-16)), 0.01);
  EXPECT_LE(std::stod(value_at(draw, 1.0 - 1e-16)), 100.0);
}

}  // namespace
}  // namespace wuerfel::test
