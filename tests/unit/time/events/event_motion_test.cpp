// Motion from event to event: when events happen, in which order, and which ones.
#include "core/time/events/event_motion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/scene/scene_parser.h"
#include "core/time/simulation.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

/// A motion of one group.
class Fall {
 public:
  explicit Fall(const Scene& scene) : m_(scene), motion_(m_.system, {}) {
    motion_.start(m_.state, 0.0, {}, {}, book_);
  }
  void until(double t) {
    while (motion_.clock() < t)
      motion_.advance(t, pieces_, book_);
  }
  [[nodiscard]] const EventMotion& motion() const { return motion_; }
  [[nodiscard]] const Bookkeeping& book() const { return book_; }
  [[nodiscard]] std::vector<Event> events(EventKind kind) const {
    std::vector<Event> found;
    std::ranges::copy_if(book_.events, std::back_inserter(found),
                         [&](const Event& e) { return e.kind == kind; });
    return found;
  }
  State at(double t) {
    auto piece = pieces_.rbegin();
    while (piece->begin > t)
      ++piece;
    return motion_.look(*piece, t);
  }

 private:
  Mechanism m_;
  EventMotion motion_;
  std::deque<MotionPiece> pieces_;
  Bookkeeping book_;
};

TEST(EventMotion, EventsComeInTheOrderOfTheirTimes) {
  //   a: 3 m above the floor, b: 1 m, c: 2 m, side by side
  Scene scene = on_floor({cube("a", {0.0, 3.5}), cube("b", {2.0, 1.5}), cube("c", {4.0, 2.5})});
  Fall run(scene);
  run.until(1.0);
  const auto hits = run.events(EventKind::impact);
  ASSERT_EQ(hits.size(), 6U);
  const double heights[] = {1.0, 2.0, 3.0};
  const char* names[] = {"b", "c", "a"};
  for (int k = 0; k < 6; ++k) {
    EXPECT_EQ(hits[k].on, names[k / 2]);
    EXPECT_NEAR(hits[k].t, std::sqrt(2.0 * heights[k / 2] / 9.81), 1e-14);
  }
}

TEST(EventMotion, SimultaneousEventsAreOne) {
  Fall run(on_floor({cube("a", {0.0, 1.5}), cube("b", {2.0, 1.5})}));
  run.until(1.0);
  EXPECT_EQ(run.motion().events(), 1);
  EXPECT_EQ(run.events(EventKind::impact).size(), 4U);
}

TEST(EventMotion, AFallingTurningCubeMeetsTheFloorWhereTheParabolaSays) {
  Scene scene = on_floor({cube("a", {0.0, 3.0})});
  scene.cubes[0].spin = 5.0;
  Fall run(scene);
  run.until(0.9);
  const auto hits = run.events(EventKind::impact);
  ASSERT_FALSE(hits.empty());
  const double t = hits[0].t;
  const Box box = make_box({0.0, 3.0 - 0.5 * 9.81 * t * t}, 5.0 * t, Vec2::Ones());
  EXPECT_NEAR(plane_separation(Vec2::Zero(), Vec2::UnitY(), box), 0.0, 1e-14);
}

TEST(EventMotion, WhatRestsIsKnownForEver) {
  Fall run(on_floor({cube("a", {0.0, 0.5}), cube("b", {0.2, 1.5}), cube("c", {0.0, 2.5})}));
  EXPECT_TRUE(run.motion().at_rest());
  run.until(1e9);
  EXPECT_EQ(run.book().cost.steps, 0);
  EXPECT_TRUE(run.book().events.empty());
  EXPECT_EQ(run.motion().state()[2].position, Vec2(0.0, 2.5));
}

/// A cube that turns over its lowest corner at `omega`, at angle phi from the vertical, on a floor
/// without friction. With r = 1 / sqrt(2), m = 1, I = 1/6 and omega_0 at phi = 0:
///
///   omega^2 (I + r^2 sin^2) = I omega_0^2 + 2 g r (1 - cos)
///   N = g - r (omega' sin + omega^2 cos)
struct OverItsCorner {
  double omega_0;
  static constexpr double g = 9.81, inertia = 1.0 / 6.0, r = 0.70710678118654752;

  [[nodiscard]] double omega(double phi) const {
    const double s = std::sin(phi);
    return std::sqrt((inertia * omega_0 * omega_0 + 2.0 * g * r * (1.0 - std::cos(phi)))
                     / (inertia + r * r * s * s));
  }
  [[nodiscard]] double load(double phi) const {
    const double s = std::sin(phi), c = std::cos(phi), w = omega(phi);
    const double turn = (g * r * s - r * r * s * c * w * w) / (inertia + r * r * s * s);
    return g - r * (turn * s + w * w * c);
  }
  /// Time from phi_0 to phi_1, by Simpson's rule.
  [[nodiscard]] double time(double phi_0, double phi_1) const {
    constexpr int parts = 2000;
    const double h = (phi_1 - phi_0) / parts;
    double sum = 0.0;
    for (int k = 0; k < parts; ++k) {
      const double a = phi_0 + k * h;
      sum += h / 6.0 * (1.0 / omega(a) + 4.0 / omega(a + 0.5 * h) + 1.0 / omega(a + h));
    }
    return sum;
  }
  [[nodiscard]] Scene scene(double phi) const {
    // The corner below the centre is number 0 where the cube is turned by pi/4 from lying flat.
    Scene s =
        on_floor({sized_cube("a", {0.0, r * std::cos(phi)}, Vec2::Ones(), phi + 0.25 * M_PI)});
    s.cubes[0].spin = omega(phi);
    s.cubes[0].velocity = {0.0, -r * omega(phi) * std::sin(phi)};
    return s;
  }
};

TEST(EventMotion, ALoadThatDipsBelowZeroBetweenTheStagesOfAStepIsARelease) {
  // Its load has a minimum at phi = 0 that is g (1 - r omega_0^2 / g): negative there for 2 sqrt(2
  // eps) rad only, while a step is some 0.3 rad long.
  for (const double eps : {1e-2, 1e-4, 1e-6}) {
    const OverItsCorner cube{std::sqrt(9.81 / OverItsCorner::r * (1.0 + eps))};
    ASSERT_LT(cube.load(0.0), 0.0);
    double before = -0.3, after = 0.0;
    for (int k = 0; k < 200; ++k) {
      const double middle = 0.5 * (before + after);
      (cube.load(middle) > 0.0 ? before : after) = middle;
    }
    Fall run(cube.scene(-0.3));
    const double t = cube.time(-0.3, after);
    run.until(t + 1e-3);
    const auto releases = run.events(EventKind::release);
    ASSERT_EQ(releases.size(), 1U) << eps;
    // The load's slope there is as sqrt(eps), and its error 1e-9 of the weight.
    EXPECT_NEAR(releases[0].t, t, 1e-9 / std::sqrt(eps));
  }
}

TEST(EventMotion, ALoadThatStaysPositiveIsNoRelease) {
  for (const double eps : {1e-2, 1e-4, 1e-6}) {
    const OverItsCorner cube{std::sqrt(9.81 / OverItsCorner::r * (1.0 - eps))};
    Fall run(cube.scene(-0.3));
    run.until(cube.time(-0.3, 0.3));
    EXPECT_TRUE(run.book().events.empty()) << eps;
    EXPECT_NEAR(run.motion().state()[0].angle, 0.3 + 0.25 * M_PI, 1e-9);
  }
}

TEST(EventMotion, ABlockSlidesOffATableAndTips) {
  //   +---+ ->
  //   |   |
  // +--------+  edge at x = 0; the centre passes it at t = 0.4, when the block begins to tip
  // | table  |
  Scene scene;
  scene.fixed.push_back(post("table", {-2.0, -0.5}, {4.0, 1.0}));
  scene.cubes = {cube("a", {-0.4, 0.5})};
  scene.cubes[0].velocity = {1.0, 0.0};
  Fall run(scene);
  run.until(0.45);
  const auto releases = run.events(EventKind::release);
  ASSERT_EQ(releases.size(), 1U);
  EXPECT_NEAR(releases[0].t, 0.4, 1e-10);
  EXPECT_TRUE(run.events(EventKind::touch).empty());
}

TEST(EventMotion, ASeamIsTouchedWhereItBeginsToBear) {
  //   +---+ ->
  //   | a |          Two tables of one height, seam at x = 0. At t = 0.5 the block arrives at q; at
  // +-------+-----+  t = 1 its centre does, and p alone no longer bears it.
  // |   p   |  q  |
  Scene scene;
  scene.fixed = {post("p", {-1.0, -0.5}, {2.0, 1.0}), post("q", {1.0, -0.5}, {2.0, 1.0})};
  scene.cubes = {cube("a", {-1.0, 0.5})};
  scene.cubes[0].velocity = {1.0, 0.0};
  for (const double look : {0.9, 1.2, 0.51}) {
    Fall run(scene);
    run.until(look);
    run.until(1.2);
    const auto touches = run.events(EventKind::touch);
    ASSERT_EQ(touches.size(), 1U);
    EXPECT_TRUE(touches[0].from == "q" || touches[0].on == "q");
    EXPECT_NEAR(touches[0].t, 1.0, 1e-10);
    EXPECT_NEAR(run.motion().state()[0].velocity.x(), 1.0, 1e-12);
    EXPECT_NEAR(run.motion().state()[0].position.y(), 0.5, 1e-14);
  }
}

/// What touches from the beginning is no touch later, whoever else is there: B and C touch since t =
/// 0, A and B since their impact. D stands 1.5 m away and only changes the groups.
TEST(EventMotion, WhatTouchedAlreadyIsNoTouch) {
  for (const double d : {5.5, 50.5}) {
    Scene scene;
    scene.gravity = Vec2::Zero();
    scene.cubes = {cube("A", {0.0, 0.0}), cube("B", {3.0, 0.0}), cube("C", {4.0, 0.0}),
                   cube("D", {d, 0.0})};
    scene.cubes[0].velocity = {2.0, 0.0};
    scene.cubes[2].mass = 3.0;
    Simulation simulation(scene, {});
    simulation.advance_to(1.5);
    int impacts = 0;
    for (const Event& e : simulation.events()) {
      EXPECT_EQ(e.kind, EventKind::impact) << to_string(e.kind) << " at " << e.t;
      EXPECT_NEAR(e.t, 1.0, 1e-14);
      ++impacts;
    }
    EXPECT_EQ(impacts, 4);
  }
}

TEST(EventMotion, WhatIsPutRightWhereARodHoldsIsGivenByItsFixedEnd) {
  // b turns into a, to which a rod along their sides joins it, so that forces of rod and contacts are 10^6 times what they do
  // together: velocities are off by as much.
  Simulation simulation(parse_scene(R"(
cube = [{ name = "a", position = [1, 1] }, { name = "b", position = [2, 1] }, { name = "top", position = [1, 2] }]
rod = [{ from = "b.n", to = "a.n" }, { from = "a.ne", to = [2, 3] }]
)",
                                    "tied.toml"),
                        {});
  simulation.advance_to(0.02);
  EXPECT_LE(simulation.audit().momentum_linear, 1e-12);
  EXPECT_LE(simulation.audit().momentum_settled, 0.1);
}

}  // namespace
}  // namespace wuerfel::test
