// Each skip of work changes no answer, and does skip something: motion with and without it.
#include <cmath>

#include <gtest/gtest.h>

#include "core/scene/scene_parser.h"
#include "core/time/simulation.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

constexpr double same_motion = 1e-9;
constexpr double same_force = 1e-5;  // N

/// A standing tower, a sliding pair, a cube that drops onto the tower's neighbour, and one in free
/// flight.
Scene mixed() {
  std::vector<SceneCube> cubes = tower(4);
  cubes.push_back(cube("low", {3.0, 0.5}));
  cubes.push_back(cube("high", {3.6, 1.5}));
  cubes.push_back(cube("base", {6.0, 0.5}));
  cubes.push_back(cube("drop", {6.3, 2.0}, 0.2, 0.5));
  cubes.push_back(cube("free", {9.0, 8.0}, 0.1, 2.0));
  return on_floor(cubes);
}

/// A wall that slides for ever, so that every step has its programs.
Scene sliding() {
  Scene scene = parse_scene("[[plane]]\n[[wall]]\nbase = [0, 0]\nrows = 6\ncolumns = 5\n", "wall");
  for (SceneCube& c : scene.cubes)
    c.velocity = {1.0, 0.0};
  return scene;
}

/// A stack falls onto a pyramid: events crowd, and what is stepped then has programs of many contacts.
Scene crowded() { return shipped_scene("demo_frictionless"); }

/// A tower that leans too far, and rubs.
Scene rubbing() {
  Scene scene = on_floor(leaning_tower(6, 0.3));
  for (SceneCube& c : scene.cubes)
    c.material.friction = 0.4;
  scene.planes[0].material.friction = 0.4;
  return scene;
}

struct Switch {
  const char* name;
  bool Skips::*flag;
  /// What is less where the skip is on.
  long (*work)(const Simulation&);
  Scene (*scene)() = mixed;
  Integrator integrator = Integrator::automatic;
};

long solves(const Simulation& s) { return s.cost().qp_solves; }
long iterations(const Simulation& s) { return s.cost().qp_iterations; }
long steps(const Simulation& s) { return s.cost().steps; }
long changed_looks(const Simulation& s) { return -s.look_cost().unchanged; }
long look_solves(const Simulation& s) { return s.look_cost().qp_solves; }

/// Forces on a cube, N.
Vec2 force_on(const Snapshot& snapshot, int body) {
  Vec2 sum = Vec2::Zero();
  for (const SnapshotForce& arrow : snapshot.forces) {
    if (arrow.body == body) sum += arrow.force;
  }
  return sum;
}

class Skip : public testing::TestWithParam<Switch> {};

TEST_P(Skip, SavesWorkAndDoesNotChangeTheMotion) {
  MotionSettings with;
  with.integrator = GetParam().integrator;
  // Else nothing is left to start from: the former answers still pass.
  with.skips.certificate = GetParam().flag != &Skips::warm_start;
  MotionSettings without = with;
  without.skips.*GetParam().flag = false;
  Simulation a(GetParam().scene(), with);
  Simulation b(GetParam().scene(), without);
  for (int k = 1; k <= 10; ++k) {
    a.advance_to(0.08 * k);
    b.advance_to(0.08 * k);
    for (std::size_t i = 0; i < a.states().size(); ++i) {
      EXPECT_NEAR((a.states()[i].position - b.states()[i].position).norm(), 0.0, same_motion) << i;
      EXPECT_NEAR(a.states()[i].angle, b.states()[i].angle, same_motion) << i;
      EXPECT_NEAR((a.states()[i].velocity - b.states()[i].velocity).norm(), 0.0, 1e3 * same_motion)
          << i;
    }
    const Snapshot p = a.snapshot({.forces = true});
    const Snapshot q = b.snapshot({.forces = true});
    EXPECT_EQ(p.forces.size(), q.forces.size()) << k;
    for (int i = 0; i < static_cast<int>(a.states().size()); ++i)
      EXPECT_NEAR((force_on(p, i) - force_on(q, i)).norm(), 0.0, same_force) << k << " " << i;
  }
  EXPECT_EQ(a.audit().missed_solves, 0);
  EXPECT_EQ(b.audit().missed_solves, 0);
  EXPECT_LT(GetParam().work(a), GetParam().work(b));
}

INSTANTIATE_TEST_SUITE_P(
    All,
    Skip,
    testing::Values(Switch{"free_bodies", &Skips::free_bodies, steps},
                    Switch{"islands", &Skips::islands, solves},
                    Switch{"islands_of_looks", &Skips::islands, changed_looks},
                    Switch{"rest", &Skips::rest, solves},
                    Switch{"certificate", &Skips::certificate, solves},
                    Switch{"warm_start", &Skips::warm_start, iterations, crowded},
                    Switch{"warm_start_of_friction", &Skips::warm_start, iterations, rubbing},
                    Switch{"warm_start_of_grid_points", &Skips::warm_start, iterations, sliding,
                           Integrator::symplectic},
                    Switch{"looks", &Skips::looks, look_solves}),
    [](const auto& test) { return std::string(test.param.name); });

/// Dominoes far enough apart that only neighbours meet: the last ones stand while the first ones fall.
Scene standing() {
  Scene scene = shipped_scene("dominoes_100");
  scene.cubes.resize(40);
  return scene;
}

TEST(Skips, OfStepsOfWhatRestsLeaveEveryBitAsItIs) {
  Simulation a(standing(), {});
  Simulation b(standing(), {.skips = {.resting_steps = false}});
  a.advance_to(1.0);
  b.advance_to(1.0);
  EXPECT_EQ(a.state_hash(), b.state_hash());
  EXPECT_EQ(a.cost().steps, b.cost().steps);
  EXPECT_EQ(a.events().size(), b.events().size());
  EXPECT_EQ(a.audit().missed_solves, b.audit().missed_solves);
  EXPECT_LT(2 * a.cost().qp_solves, b.cost().qp_solves);
}

/// A cube tips from a wall that rubs, and a ball falls on it. Forces of the wall are not the only ones, nor asked for. What that
/// saves are no programs but equations: `bench --scenes tilt_on_wall_3`.
TEST(Skips, OfWhatStandsDoesNotChangeTheMotion) {
  Scene scene = parse_scene(
      "[[plane]]\n[[wall]]\nbase = [0, 0]\nrows = 2\ncolumns = 3\nsize = [1, 1]\n", "wall");
  const Vec2 last = scene.cubes.back().position;
  scene.cubes.push_back(cube("tips", last + Vec2(0.55, 1.0)));
  scene.cubes.push_back(sized_cube("ball", last + Vec2(-1.2, 1.3), {0.4, 0.4}, 0.3));
  for (SceneCube& c : scene.cubes)
    c.material.friction = 0.6;
  scene.cubes.back().material.friction = 0.0;
  scene.planes.front().material.friction = 0.6;
  Simulation a(scene, {});
  Simulation b(scene, {.skips = {.standing = false}});
  for (int k = 1; k <= 10; ++k) {
    a.advance_to(0.05 * k);
    b.advance_to(0.05 * k);
    for (std::size_t i = 0; i < a.states().size(); ++i) {
      EXPECT_NEAR((a.states()[i].position - b.states()[i].position).norm(), 0.0, same_motion) << i;
      EXPECT_NEAR(a.states()[i].angle, b.states()[i].angle, same_motion) << i;
    }
  }
  const auto of_ball = [](const Simulation& s) {
    std::vector<double> times;
    for (const Event& e : s.events())
      if (e.on == "ball" || e.from == "ball") times.push_back(e.t);
    return times;
  };
  const std::vector<double> blows = of_ball(a);
  ASSERT_GE(blows.size(), 2U);
  ASSERT_EQ(blows.size(), of_ball(b).size());
  for (std::size_t k = 0; k < blows.size(); ++k)
    EXPECT_NEAR(blows[k], of_ball(b)[k], same_motion) << k;
  EXPECT_GT(a.events().size(), blows.size()) << "what stands passes on";
}

TEST(Skips, AreCountedByReason) {
  Simulation simulation(mixed(), {});
  simulation.advance_to(0.5);
  EXPECT_GT(simulation.cost().skipped_free, 0);
  EXPECT_GT(simulation.cost().skipped_rest, 0);
  EXPECT_EQ(simulation.cost().qp_skipped(), simulation.cost().skipped_free
                                                + simulation.cost().skipped_rest
                                                + simulation.cost().skipped_certificate);
}

}  // namespace
}  // namespace wuerfel::test
