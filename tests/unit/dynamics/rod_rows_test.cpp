// Rows of rods and pins on their bodies against finite differences of the bodies' motions.
#include "core/dynamics/rod_rows.h"

#include <array>

#include <gtest/gtest.h>

#include "core/dynamics/momentum.h"
#include "tests/support/random_motion.h"

namespace wuerfel::test {
namespace {

/// Two cubes that turn, and a rod of some kind between places of them, or from one to a fixed place.
struct Joined {
  std::array<CubicMotion, 2> place;
  std::array<CubicMotion, 2> turn;  ///< the angle is the first coordinate
  Rod rod;

  Joined(RandomNumbers& random, Rod::Kind kind, bool held)
      : place{CubicMotion(random), CubicMotion(random)},
        turn{CubicMotion(random), CubicMotion(random)} {
    place[1].c[0] += Vec2(4.0, 1.0);
    rod.kind = kind;
    rod.length = kind == Rod::Kind::rod ? 3.0 : 0.0;
    rod.i = {0, random.next_vec2(), 0};
    rod.j = held ? RodEnd{-1, {5.0, 2.0}, -1} : RodEnd{1, random.next_vec2(), 1};
  }
  [[nodiscard]] State at(double t) const {
    constexpr double h = 1e-4;
    State state(2);
    for (std::size_t i = 0; i < 2; ++i) {
      state[i].position = place[i].at(t);
      state[i].angle = turn[i].at(t).x();
      state[i].velocity = (place[i].at(t + h) - place[i].at(t - h)) / (2.0 * h);
      state[i].spin = (turn[i].at(t + h) - turn[i].at(t - h)).x() / (2.0 * h);
    }
    return state;
  }
  /// What the row says of velocities, or accelerations.
  [[nodiscard]] double value(Order order) const {
    const BodyRodRow row = rod_row(rod, at(0.0), order);
    const bool second = order == Order::acceleration;
    const auto part = [&](const std::array<double, 3>& g, std::size_t i) {
      const Vec2 rate = second ? place[i].a() : place[i].v();
      return g[0] * rate.x() + g[1] * rate.y() + g[2] * (second ? turn[i].a() : turn[i].v()).x();
    };
    return part(row.i, 0) + part(row.j, 1) + row.c;
  }
  [[nodiscard]] auto excess() const {
    return [this](double t) { return rod_excess(rod, at(t)); };
  }
};

TEST(RodRows, AreTheDerivativesOfTheLength) {
  RandomNumbers random(11);
  for (int trial = 0; trial < trials; ++trial) {
    const Joined joined(random, Rod::Kind::rod, trial % 2 == 0);
    const double rate = first_difference(joined.excess(), 1e-3);
    EXPECT_NEAR(joined.value(Order::velocity), rate, 1e-8);
    EXPECT_NEAR(rod_rate(joined.rod, joined.at(0.0)), rate, 1e-7);
    // The row is that of a rod that keeps its length: without the square of its rate over the length.
    const double length = joined.excess()(0.0) + joined.rod.length;
    EXPECT_NEAR(joined.value(Order::acceleration),
                second_difference(joined.excess(), 2e-3) + rate * rate / length, 2e-6);
  }
}

TEST(RodRows, OfPinsAreTheDerivativesOfTheDistanceAlongTheAxes) {
  RandomNumbers random(12);
  for (int trial = 0; trial < trials; ++trial) {
    const Rod::Kind kind = trial % 2 == 0 ? Rod::Kind::pin_x : Rod::Kind::pin_y;
    const Joined joined(random, kind, trial % 3 == 0);
    EXPECT_NEAR(joined.value(Order::velocity), first_difference(joined.excess(), 1e-3), 1e-8);
    EXPECT_NEAR(joined.value(Order::acceleration), second_difference(joined.excess(), 2e-3), 2e-6);
  }
}

TEST(RodRows, OfAPlacementCloseTheExcess) {
  RandomNumbers random(13);
  const Joined joined(random, Rod::Kind::rod, false);
  const BodyRodRow row = rod_row(joined.rod, joined.at(0.0), Order::position);
  EXPECT_DOUBLE_EQ(row.c, rod_excess(joined.rod, joined.at(0.0)));
}

TEST(RodRows, ImpulsesKeepMomentumAndAngularMomentum) {
  Scene scene;
  scene.cubes.resize(2);
  scene.cubes[0].name = "a";
  scene.cubes[1].name = "b";
  scene.cubes[1].mass = 3.0;
  const System system = make_system(scene);
  RandomNumbers random(14);
  const Joined joined(random, Rod::Kind::rod, false);
  const State before = joined.at(0.0);
  State after = before;
  push(system, joined.rod, 2.5, before, after);
  const std::array<int, 2> both = {0, 1};
  const Momentum a = momentum_of(system, before, both);
  const Momentum b = momentum_of(system, after, both);
  EXPECT_NEAR((a.linear - b.linear).norm(), 0.0, 1e-14);
  EXPECT_NEAR(a.angular, b.angular, 1e-13);
  EXPECT_GT((after[0].velocity - before[0].velocity).norm(), 2.0);
}

}  // namespace
}  // namespace wuerfel::test
