// Rows of a contact on its cubes against finite differences of the cubes' motions.
#include "core/dynamics/contact_rows.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "core/constraints/manifold.h"
#include "core/dynamics/momentum.h"
#include "tests/support/random_motion.h"

namespace wuerfel::test {
namespace {

/// A corner of one cube on a side of another one, both turning, the corner keeping to the side's
/// line to first order.
///
///            .'\   on
///          .'   /
///      ____\__.'__
///     |  from     |
struct Pair {
  System system;
  std::array<CubicMotion, 2> place;
  std::array<CubicMotion, 2> turn;  ///< the angle is the first coordinate
  Contact contact;

  explicit Pair(RandomNumbers& random)
      : system(make_system(two_cubes())),
        place{CubicMotion(random), CubicMotion(random)},
        turn{CubicMotion(random), CubicMotion(random)} {
    const State state = at(0.0);
    std::array<Box, 2> boxes = {box(state, 0), box(state, 1)};
    const double alpha = 0.5 + 0.4 * random.next();
    const Vec2 from_i = boxes[0].arm[next_corner(2)];
    const Vec2 from_j = boxes[0].arm[2];
    place[1].c[0] = place[0].c[0] + alpha * from_j + (1.0 - alpha) * from_i - boxes[1].arm[0];
    boxes[1] = box(at(0.0), 1);
    contact = corner_on_side(1, boxes[1], 0, 0, boxes[0], 2);
    place[1].c[1] -= gap_rate(contact, contact_velocity(system, at(0.0), contact)) * contact.normal;
  }
  static Scene two_cubes() {
    Scene scene;
    scene.cubes.resize(2);
    scene.cubes[0].name = "from";
    scene.cubes[1].name = "on";
    return scene;
  }
  [[nodiscard]] State at(double t) const {
    State state(2);
    for (std::size_t i = 0; i < 2; ++i) {
      const double h = 1e-4;
      state[i].position = place[i].at(t);
      state[i].angle = turn[i].at(t).x();
      state[i].velocity = (place[i].at(t + h) - place[i].at(t - h)) / (2.0 * h);
      state[i].spin = (turn[i].at(t + h) - turn[i].at(t - h)).x() / (2.0 * h);
    }
    return state;
  }
  [[nodiscard]] Box box(const State& state, int i) const {
    return make_box(state[i].position, state[i].angle, system.body(i).size);
  }
  [[nodiscard]] Contact contact_at(double t) const {
    const State state = at(t);
    return corner_on_side(1, box(state, 1), 0, 0, box(state, 0), 2);
  }
  /// Where the corner is along the normal turned left, in the side's frame.
  [[nodiscard]] double slid(double t) const {
    const Contact c = contact_at(t);
    return -c.alpha * c.length;
  }
  /// The row's value in the rates of the cubes: first derivatives, or second ones.
  [[nodiscard]] double value(const ContactRow& row, bool accelerations) const {
    const auto rate = [&](const CubicMotion& m) { return accelerations ? m.a() : m.v(); };
    const auto part = [&](const std::array<double, 3>& g, std::size_t i) {
      return g[0] * rate(place[i]).x() + g[1] * rate(place[i]).y() + g[2] * rate(turn[i]).x();
    };
    return part(row.on, 1) + part(row.from, 0) + row.c;
  }
  [[nodiscard]] ContactRow row(Order order, bool along) const {
    const State state = at(0.0);
    const SideRow on_points = along ? tangential_row(system, state, contact, order)
                                    : normal_row(system, state, contact, order);
    return pull_back(system, state, contact, order, on_points);
  }
};

TEST(ContactRows, OfVelocitiesAreTheRatesOfGapAndSlide) {
  RandomNumbers random(1);
  for (int trial = 0; trial < trials; ++trial) {
    const Pair p(random);
    EXPECT_NEAR(p.value(p.row(Order::velocity, false), false),
                first_difference([&](double t) { return p.contact_at(t).gap; }, 1e-3), 1e-8);
    EXPECT_NEAR(p.value(p.row(Order::velocity, true), false),
                first_difference([&](double t) { return p.slid(t); }, 1e-3), 1e-8);
  }
}

TEST(ContactRows, OfAccelerationsAreTheSecondRates) {
  RandomNumbers random(2);
  for (int trial = 0; trial < trials; ++trial) {
    const Pair p(random);
    EXPECT_NEAR(p.value(p.row(Order::acceleration, false), true),
                second_difference([&](double t) { return p.contact_at(t).gap; }, 2e-3), 1e-6);
    EXPECT_NEAR(p.value(p.row(Order::acceleration, true), true),
                second_difference([&](double t) { return p.slid(t); }, 2e-3), 1e-6);
  }
}

TEST(ContactRows, AcrossAnOpenGapImpulsesWorkOnTheSlideOfTheirRows) {
  // What a program says of a tangential impulse is what the impulse does: the side's body is met where the corner is.
  RandomNumbers random(5);
  const Pair pair(random);
  State state = pair.at(0.0);
  state[1].position += 0.05 * pair.contact.normal;
  const std::array<Box, 2> boxes = {pair.box(state, 0), pair.box(state, 1)};
  const Contact c = at_poses(pair.system, boxes, pair.contact);
  ASSERT_NEAR(c.gap, 0.05, 1e-12);
  const double slide = relative_velocity(pair.system, state, c).dot(perp(c.normal));
  EXPECT_NEAR(slip_rate(pair.system, state, c), slide, 1e-13);
  // Without the gap's share they would not be the same.
  EXPECT_GT(std::abs(state[0].spin), 0.1);
}

TEST(ContactRows, OfPositionsBeginAtTheGapAndAtNoSlide) {
  RandomNumbers random(3);
  Pair p(random);
  p.contact.gap = 0.25;
  EXPECT_EQ(p.row(Order::position, false).c, 0.25);
  EXPECT_EQ(p.row(Order::position, true).c, 0.0);
  EXPECT_EQ(p.row(Order::position, false).on, p.row(Order::velocity, false).on);
  EXPECT_EQ(p.row(Order::position, true).from, p.row(Order::velocity, true).from);
}

}  // namespace
}  // namespace wuerfel::test
