// The polynomial of a step.
#include "core/time/events/dop853.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/random_motion.h"

namespace wuerfel::test {
namespace {

TEST(DenseStep, HasTheSlopeOfItsValue) {
  RandomNumbers random(5);
  DenseStep step;
  for (int k = 0; k < DenseStep::terms; ++k)
    step.coefficients.push_back(random.next());
  constexpr double ds = 1e-5;
  for (const double s : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    const double difference = (step.component(s + ds, 0) - step.component(s - ds, 0)) / (2.0 * ds);
    EXPECT_NEAR(step.slope(s, 0), difference, 1e-8);
  }
}

// y' = (y_1, -y_0, 1): a circle and a clock.
void circle(const std::vector<double>& y, std::vector<double>& rate) { rate = {y[1], -y[0], 1.0}; }

TEST(DenseStep, JoinsTheEndsWithTheirRates) {
  const double h = 0.4;
  const std::vector<double> y = {1.0, 0.0, 0.0};
  std::vector<double> rate;
  circle(y, rate);
  Dop853 method;
  method.step(circle, y, rate, h);
  std::vector<double> next_rate;
  circle(method.next(), next_rate);
  DenseStep step;
  method.dense(circle, y, next_rate, step);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(step.component(0.0, i), y[i]);
    EXPECT_NEAR(step.component(1.0, i), method.next()[i], 1e-15);
    EXPECT_NEAR(step.slope(0.0, i), h * rate[i], 1e-15);
    EXPECT_NEAR(step.slope(1.0, i), h * next_rate[i], 1e-15);
  }
  EXPECT_NEAR(step.component(0.3, 0), std::cos(0.3 * h), 1e-9);
  EXPECT_NEAR(step.component(0.3, 2), 0.3 * h, 1e-15);
}

TEST(Dop853, ErrorIsSmallWhereTheStepIs) {
  const std::vector<double> y = {1.0, 0.0, 0.0};
  std::vector<double> rate;
  circle(y, rate);
  const std::vector<double> scale(3, 1e-10);
  Dop853 method;
  method.step(circle, y, rate, 0.1);
  EXPECT_LT(method.error(scale), 1e-2);
  method.step(circle, y, rate, 2.0);
  EXPECT_GT(method.error(scale), 1.0);
}

}  // namespace
}  // namespace wuerfel::test
