// Numbers with units as pictures show them.
#include "render/picture/units.h"

#include <gtest/gtest.h>

namespace wuerfel::test {
namespace {

TEST(Units, HavePrefixesBothWays) {
  using internal::energy_label;
  using internal::with_prefix;
  using internal::Zeros;
  EXPECT_EQ(with_prefix(5e12, "N"), "5 TN");
  EXPECT_EQ(with_prefix(2000.0, "N"), "2 kN");
  EXPECT_EQ(with_prefix(2e-12, "N"), "2 pN");
  EXPECT_EQ(with_prefix(24.83, "N", 3), "24.8 N");
  EXPECT_EQ(with_prefix(243.0, "N", 2), "240 N");
  EXPECT_EQ(with_prefix(0.3, "N", 2), "300 mN");
  EXPECT_EQ(with_prefix(15.0, "N", 3, Zeros::kept), "15.0 N");
  EXPECT_EQ(with_prefix(124.9, "N", 3, Zeros::kept), "125 N");
  EXPECT_EQ(with_prefix(999.9, "N", 3), "1 kN");
  EXPECT_EQ(with_prefix(6.867e18, "N", 3, Zeros::kept), "6.87e+18 N");
  EXPECT_EQ(with_prefix(5e-17, "N", 3, Zeros::kept), "5.00e-17 N");
  EXPECT_EQ(with_prefix(5e18, "N"), "5e+18 N");
  EXPECT_EQ(energy_label(4.905e-9, 0.0), "4.90 nJ");
  EXPECT_EQ(energy_label(7.848e16, 0.0), "78.48 PJ");
  EXPECT_EQ(energy_label(843.7, 843.7), "843.7 J");
  EXPECT_EQ(energy_label(12.0, 843.7), "12.0 J") << "digits stand still";
  EXPECT_EQ(energy_label(0.0, 0.0), "0.00 J");
  EXPECT_EQ(energy_label(-60.784, 60.784), "−60.78 J");
  EXPECT_EQ(energy_label(-0.003, 5.0), "0.00 J") << "a sign would be of nothing";
}

TEST(Units, ChangesHaveThePrefixOfWhatChanges) {
  using internal::energy_change_label;
  EXPECT_EQ(energy_change_label(0.4882, 58.61), "0.488 J");
  EXPECT_EQ(energy_change_label(0.0123, 58.61), "0.0123 J");
  EXPECT_EQ(energy_change_label(1.0, 100.0), "1.00 J");
  EXPECT_EQ(energy_change_label(124.9, 843.7), "124.9 J");
  EXPECT_EQ(energy_change_label(7.8e-4, 58.61), "0.00078 J");
  EXPECT_EQ(energy_change_label(12.5, 7.848e4), "0.0125 kJ");
  EXPECT_EQ(energy_change_label(0.0019, 0.95), "1.90 mJ");
}

TEST(Units, TimesHaveTheDigitsThatTellFramesApart) {
  using internal::time_label;
  EXPECT_EQ(time_label(1.6, 1.0 / 60.0), "1.600 s");
  EXPECT_EQ(time_label(0.00012, 1e-5), "0.000120 s");
  EXPECT_EQ(time_label(0.00012, 0.0), "0.00012 s") << "a still picture";
  EXPECT_EQ(time_label(2.0, 0.0), "2.000 s");
}

}  // namespace
}  // namespace wuerfel::test
