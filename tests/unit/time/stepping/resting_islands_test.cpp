// What rests is left alone in steps, until somebody comes.
#include "core/time/stepping/resting_islands.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/time/stepping/rattle_stepper.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

constexpr double step_length = 0.01;  // s

/// Two unit cubes on a floor, 2 m apart, all with this friction.
Scene two_cubes(double friction) {
  Scene scene = on_floor({cube("a", {0.0, 0.5}), cube("b", {3.0, 0.5})});
  for (SceneCube& c : scene.cubes)
    c.material.friction = friction;
  scene.planes[0].material.friction = friction;
  return scene;
}

/// Steps one after the other.
struct Steps {
  explicit Steps(const Scene& scene, const MotionSettings& settings = {})
      : m(scene), stepper(m.system, settings, 0.0), state(m.state) {
    stepper.begin(state);
  }
  Step take(double length = step_length) {
    Step step = stepper.step(state, 0.0, length);
    stepper.accept(step);
    state = step.state;
    return step;
  }
  Mechanism m;
  RattleStepper stepper;
  State state;
};

TEST(RestingIslands, NeedNoProgramsFromTheSecondStepOn) {
  Steps steps(two_cubes(0.5));
  EXPECT_GE(steps.take().book.cost.qp_solves, 4);
  const Step next = steps.take(0.5 * step_length);
  EXPECT_EQ(next.book.cost.qp_solves, 0);
  EXPECT_EQ(next.book.cost.skipped_rest, 4);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(is_still(steps.state[i]));
    EXPECT_EQ(steps.state[i].position, steps.m.state[i].position);
  }
  // The floor carries their weights all the same.
  Vec2 impulse = Vec2::Zero();
  for (const StepImpulse& p : next.record->impulses)
    impulse += p.linear;
  EXPECT_NEAR(impulse.y(), 2.0 * g * 0.5 * step_length, 1e-12);
  EXPECT_NEAR(impulse.x(), 0.0, 1e-12);
  EXPECT_NEAR(next.book.unexplained.linear.norm(), 0.0, 1e-12);
}

TEST(RestingIslands, AreSolvedAgainWhereSomebodyComes) {
  Scene scene = two_cubes(0.5);
  scene.cubes[1].position = {1.045, 0.5};
  scene.cubes[1].velocity = {-2.0, 0.0};
  Steps steps(scene);
  steps.take();
  EXPECT_TRUE(is_still(steps.state[0]));
  steps.take();
  EXPECT_TRUE(is_still(steps.state[0]));
  for (int k = 0; k < 2; ++k)
    steps.take();
  EXPECT_LT(steps.state[0].velocity.x(), -0.5);
}

TEST(RestingIslands, AreNoneWhereNothingRubs) {
  Steps steps(two_cubes(0.0));
  steps.take();
  EXPECT_GT(steps.take().book.cost.qp_solves, 0);
}

TEST(RestingIslands, AreNoneWhereSomethingBeginsToTopple) {
  Scene scene = two_cubes(0.5);
  scene.cubes[0].angle = 0.6;
  scene.cubes[0].position.y() = 0.5 * (std::cos(0.6) + std::sin(0.6));
  Steps steps(scene);
  steps.take();
  EXPECT_FALSE(is_still(steps.state[0]));
  EXPECT_EQ(steps.take().book.cost.skipped_rest, 2);
}

TEST(RestingIslands, AreWhereTheyAreIfTheyAreSolvedAllTheSame) {
  const MotionSettings settings{.skips = {.resting_steps = false}};
  Steps steps(two_cubes(0.5), settings);
  steps.take();
  EXPECT_GE(steps.take(0.5 * step_length).book.cost.qp_solves, 4);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(is_still(steps.state[i]));
    EXPECT_EQ(steps.state[i].position, steps.m.state[i].position);
  }
}

TEST(RestingIslands, AreNotFoundWhereSomebodyPressedWhoHasLeft) {
  const Mechanism m(two_cubes(0.5));
  Workspace work(m.system, {});
  const std::vector<Contact> contacts = work.finder.find(m.system, m.state);
  const std::vector<Island> islands = find_islands(m.system, contacts);
  ASSERT_EQ(islands.size(), 2U);
  Stride stride{step_length, scales_of(m.system, m.state), m.state, m.state, m.state, {}};
  const Vec2 held(0.0, 0.25 * g * step_length);
  for (const Contact& c : contacts)
    stride.blows[c.id()] = {c, c, held, held};
  for (const bool visited : {false, true}) {
    if (visited) {
      Contact blow = contacts.front();
      blow.on = 0;
      blow.from = 1;
      stride.blows[blow.id()] = {blow, blow, held, Vec2::Zero()};
    }
    RestingIslands resting(work);
    State end = m.state;
    resting.find(stride, islands, end);
    for (const Island& island : islands)
      EXPECT_EQ(resting.skipped(island, m.state) == nullptr, visited);
  }
}

}  // namespace
}  // namespace wuerfel::test
