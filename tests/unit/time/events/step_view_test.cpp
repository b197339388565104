// A step as the search for events sees it: polynomials made by hand.
#include "core/time/events/step_view.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

/// A step of `length` s of one cube that falls freely, as a polynomial: c_0 + s (c_1 + (1 - s) c_2) per component.
DenseStep falling(const BodyState& from, double length, const Vec2& gravity) {
  DenseStep motion;
  motion.coefficients.assign(components * DenseStep::terms, 0.0);
  const auto set = [&](std::size_t component, double start, double rate, double second) {
    double* c = motion.coefficients.data() + component * DenseStep::terms;
    const double half = 0.5 * second * length * length;
    c[0] = start;
    c[1] = rate * length + half;
    c[2] = -half;
  };
  for (const int axis : {0, 1}) {
    set(axis, from.position[axis], from.velocity[axis], gravity[axis]);
    set(3 + axis, from.velocity[axis], gravity[axis], 0.0);
  }
  set(2, from.angle, from.spin, 0.0);
  set(5, from.spin, 0.0, 0.0);
  return motion;
}

/// A cube 3 m above the floor, thrown at (1, 2) m/s, beside a post; a step of half a second.
class Thrown {
 public:
  Thrown() : m_(scene()), view(m_.system) {
    motion_ = falling(m_.state[0], length, m_.system.gravity);
    range_ = {{{m_.system.gravity, 0.0}, {m_.system.gravity, 0.0}}};
    view.begin({0}, 0.0);
    view.set(motion_, length, range_);
  }
  static constexpr double length = 0.5;
  static constexpr double fall = 9.81 * length * length;

 private:
  static Scene scene() {
    Scene scene = on_floor({cube("a", {0.0, 3.5})});
    scene.fixed = {post("post", {2.0, 3.5}, {1.0, 9.0})};
    scene.cubes[0].velocity = {1.0, 2.0};
    return scene;
  }
  Mechanism m_;
  DenseStep motion_;
  std::vector<TwistRange> range_;

 public:
  StepView view;
};

/// The gap of a lower corner of the cube from the floor, body 2.
const EventFunction corner_height{EventFunction::Kind::gap, 0, 2, 0, plane_side, {}};
const EventFunction to_post{EventFunction::Kind::separation, 0, 1, 0, 0, {}};

TEST(StepView, FunctionsAreReadFromThePolynomialInUnitsOfTheStep) {
  const Thrown t;
  for (const double s : {0.0, 0.3, 1.0}) {
    const Jet jet = t.view.look_at(corner_height, s).jet;
    EXPECT_NEAR(jet.value, 3.0 + s - 0.5 * Thrown::fall * s * s, 1e-14);
    EXPECT_NEAR(jet.first, 1.0 - Thrown::fall * s, 1e-14);
    EXPECT_NEAR(jet.second, -Thrown::fall, 1e-14);
  }
}

TEST(StepView, SeparationIsByTheBestSide) {
  const Thrown t;
  const StepView::Look look = t.view.look_at(to_post, 0.4);
  EXPECT_NEAR(look.jet.value, 1.0 - 0.5 * 0.4, 1e-14);
  EXPECT_NEAR(look.jet.first, -0.5, 1e-14);
}

TEST(StepView, ProvesThatAFunctionStaysPositiveAndOnlyThen) {
  const Thrown t;
  const StepView::Look begin = t.view.look_at(corner_height, 0.0);
  const StepView::Look end = t.view.look_at(corner_height, 1.0);
  EXPECT_TRUE(t.view.positive_between(corner_height, begin, end, 0.0));
  // Lowered by more than the lowest point, which is the end.
  EXPECT_FALSE(t.view.positive_between(corner_height, begin, end, -end.jet.value - 1e-6));
  EXPECT_TRUE(t.view.positive_between(corner_height, begin, end, -end.jet.value + 0.1));
  // Lowered by more than where it begins, and rises from.
  EXPECT_FALSE(
      t.view.positive_between(corner_height, begin, t.view.look_at(corner_height, 0.3), -3.1));
  const StepView::Look from = t.view.look_at(to_post, 0.0);
  const StepView::Look to = t.view.look_at(to_post, 1.0);
  EXPECT_TRUE(t.view.positive_between(to_post, from, to, 0.0));
  EXPECT_FALSE(t.view.positive_between(to_post, from, to, -0.6));
  EXPECT_GE(t.view.second_bound(corner_height, begin, end), Thrown::fall);
}

TEST(StepView, AWayLeavesItsChordByNoMoreThanTheBulge) {
  const Thrown t;
  const Vec2 chord = 0.5 * (t.view.center_at(0, 0.0) + t.view.center_at(0, 1.0));
  const double way = t.view.look_at(corner_height, 0.5).pair.on.box.center.y();
  EXPECT_NEAR(way - chord.y(), Thrown::fall / 8.0, 1e-14);
  EXPECT_NEAR(t.view.bulge(0).y(), acceleration_reserve * Thrown::fall / 8.0, 1e-14);
  EXPECT_EQ(t.view.bulge(0).x(), 0.0);
}

TEST(StepView, StillIsWhatIsFixedOrRests) {
  Thrown t;
  EXPECT_FALSE(t.view.is_still(0));
  EXPECT_TRUE(t.view.is_still(1));
  t.view.begin({1}, 0.0);
  EXPECT_TRUE(t.view.is_still(0));
}

}  // namespace
}  // namespace wuerfel::test
