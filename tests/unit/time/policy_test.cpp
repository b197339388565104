// What an integrator means.
#include "core/time/policy.h"

#include <gtest/gtest.h>

namespace wuerfel::test {
namespace {

TEST(MotionPolicy, SaysWhatAnIntegratorMeans) {
  MotionSettings settings{.tolerance = 1e-8, .step = 0.125};
  const auto policy = [&](Integrator integrator) {
    settings.integrator = integrator;
    return policy_of(settings);
  };
  using Method = MotionPolicy::Method;
  EXPECT_EQ(policy(Integrator::automatic).method, Method::groups);
  EXPECT_EQ(policy(Integrator::automatic).step, 0.0);
  EXPECT_NEAR(policy(Integrator::automatic).allowed_error, 2e-3, 1e-18);
  EXPECT_TRUE(policy(Integrator::event).only_events);
  EXPECT_TRUE(policy(Integrator::rattle).only_steps);
  EXPECT_EQ(policy(Integrator::rattle).step, 0.125);
  EXPECT_NEAR(policy(Integrator::rattle).sway, 0.25e-4, 1e-19);
  EXPECT_EQ(policy(Integrator::moreau).method, Method::moreau);
  EXPECT_EQ(policy(Integrator::symplectic).method, Method::algorithm_1);
  EXPECT_FALSE(policy(Integrator::symplectic).as_printed);
  EXPECT_TRUE(policy(Integrator::euler).as_printed);
}

}  // namespace
}  // namespace wuerfel::test
