// What momenta change by, and what of it has a reason.
#include "core/dynamics/momentum_balance.h"

#include <gtest/gtest.h>

#include "core/scene/scene_parser.h"
#include "core/time/simulation.h"

namespace wuerfel::test {
namespace {

/// The largest share that a run of this scene leaves unexplained.
double unexplained_in(const char* text,
                      double until,
                      Integrator integrator = Integrator::automatic) {
  Simulation simulation(parse_scene(text, "scene"), {.integrator = integrator});
  simulation.advance_to(until);
  const Audit audit = simulation.audit();
  return std::max(audit.momentum_linear, audit.momentum_angular);
}

constexpr const char* tilted = R"(
[[plane]]
name = "floor"
[[cube]]
name = "a"
position = [0.0, 2.0]
angle = 0.3
spin = 1.0
velocity = [1.0, 0.0]
)";

constexpr const char* rubbing = R"(
[material]
friction = 0.3
[[plane]]
name = "floor"
[[cube]]
name = "a"
position = [0.0, 0.5]
velocity = [3.0, 0.0]
[[cube]]
name = "b"
size = 0.5
position = [0.1, 1.25]
)";

/// About itself it has no momentum that rounding could be a share of.
constexpr const char* point_alone = R"(
[[plane]]
name = "floor"
[[point]]
position = [0.0, 2.379058802825189]
velocity = [1.097124196368993, 0.01881842648233878]
mass = 0.1964589595535936
)";

/// The centre of mass is not where it is, to the last bit.
constexpr const char* sliding_point_alone = R"(
[[plane]]
name = "floor"
[[point]]
position = [-0.35914476451378863, 0.0]
velocity = [-1.5, 0.0]
mass = 0.3
)";

constexpr const char* in_space = R"(
gravity = [0.0, 0.0]
[[cube]]
name = "a"
position = [0.0, 0.0]
velocity = [1.0, 0.1]
spin = 2.0
[[cube]]
name = "b"
position = [3.0, 0.4]
mass = 3.0
angle = 0.7
)";

TEST(MomentumBalance, ClosesOverFallImpactAndRest) { EXPECT_LT(unexplained_in(tilted, 3.0), 1e-8); }

TEST(MomentumBalance, KnowsTheForcesAlongSides) { EXPECT_LT(unexplained_in(rubbing, 1.5), 1e-8); }

TEST(MomentumBalance, ClosesWhereNothingIsFixed) {
  EXPECT_LT(unexplained_in(in_space, 5.0), 1e-12);
}

TEST(MomentumBalance, ClosesOfAPointAlone) {
  EXPECT_LT(unexplained_in(point_alone, 0.4), 1e-12);
  EXPECT_LT(unexplained_in(sliding_point_alone, 0.6), 1e-12);
  EXPECT_LT(unexplained_in(sliding_point_alone, 0.6, Integrator::rattle), 1e-12);
}

TEST(MomentumBalance, ClosesInSteps) {
  EXPECT_LT(unexplained_in(in_space, 5.0, Integrator::rattle), 1e-12);
  // Its corrections move cubes out of overlap, which turns momenta about the centre by what they overlapped.
  EXPECT_LT(unexplained_in(in_space, 5.0, Integrator::moreau), 1e-3);
}

/// A cube falls on one that rests, beyond its middle, so that both move afterwards.
constexpr const char* landing = R"(
[[plane]]
name = "floor"
[[cube]]
name = "a"
position = [0.0, 0.5]
[[cube]]
name = "b"
position = [0.6, 1.8]
)";

TEST(MomentumBalance, ClosesInStepsOfOneLengthWhereSomebodyLandsOnWhatRests) {
  for (const Integrator integrator : {Integrator::moreau, Integrator::symplectic})
    EXPECT_LT(unexplained_in(landing, 1.5, integrator), 1e-6) << to_string(integrator);
}

/// A pendulum: what it hangs on is fixed to the world.
constexpr const char* hanging = R"(
[[cube]]
name = "a"
position = [1.0, 2.0]
[[rod]]
from = "a.nw"
to = [0.0, 4.0]
)";

TEST(MomentumBalance, KnowsWhatRodsToFixedPlacesDo) {
  for (const Integrator integrator :
       {Integrator::automatic, Integrator::rattle, Integrator::moreau, Integrator::symplectic})
    EXPECT_LT(unexplained_in(hanging, 3.0, integrator), 1e-8) << to_string(integrator);
}

TEST(MomentumBalance, TellsWhatHasNoReason) {
  const System system = make_system(parse_scene(in_space, "scene"));
  const State before = initial_state(parse_scene(in_space, "scene"));
  State after = before;
  after[1].velocity += Vec2(0.0, 2.0);
  after[1].spin += 0.5;
  const Push change = unexplained(system, before, after);
  EXPECT_NEAR(change.linear.y(), 6.0, 1e-14);
  EXPECT_EQ(change.linear.x(), 0.0);
  // The centre is at x = 9 / 4, b at 3.
  EXPECT_NEAR(change.angular, 0.75 * 6.0 + 0.5 * system.body(1).inertia, 1e-12);
  EXPECT_NEAR(unexplained(system, before, after, 0.0, {Vec2(0.0, 6.0), 0.0}).linear.norm(), 0.0,
              1e-14);
}

TEST(MomentumBalance, AFixedBodyPushesAndACubeDoesNot) {
  const Scene scene = parse_scene(rubbing, "scene");
  const System system = make_system(scene);
  const State state = initial_state(scene);
  Push sum;
  int fixed = 0;
  for (const Contact& c : ContactFinder().find(system, state)) {
    add_push(system, state, common_center(system, state), c, c.normal, sum);
    if (!system.is_cube(c.on) || !system.is_cube(c.from)) ++fixed;
  }
  EXPECT_EQ(fixed, 2);
  EXPECT_NEAR(sum.linear.y(), 2.0, 1e-14);
}

}  // namespace
}  // namespace wuerfel::test
