// Touches: who touches whom and how, what they bear, and which rows keep them closed.
#include "core/constraints/touch.h"

#include <gtest/gtest.h>

#include "core/constraints/islands.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

struct FoundTouches {
  Mechanism m;
  std::vector<Contact> contacts;
  std::vector<Touch> touches;
  std::vector<Box> boxes;
};

FoundTouches find_touches(const Scene& scene) {
  FoundTouches found{Mechanism(scene), {}, {}, {}};
  ContactFinder finder;
  found.contacts = finder.find(found.m.system, found.m.state);
  found.touches = finder.touches();
  found.boxes.assign(finder.boxes().begin(), finder.boxes().end());
  return found;
}

ContactSet closed_rows(const FoundTouches& f, const std::vector<char>& closed) {
  ContactSet rows;
  for (const Touch& touch : f.touches)
    add_closed_rows(f.m.system, f.boxes, touch, f.contacts, closed, rows);
  return rows;
}

TEST(Touch, IsFlushOnAPlaneOrAtACorner) {
  //      /\  tip
  //    +----+
  //    | up |      flush on low
  //   +------+
  //   |  low |
  // ~~~~~~~~~~~~
  Scene scene = on_floor({sized_cube("low", {0.0, 0.5}, {2.0, 1.0}), cube("up", {0.1, 1.5})});
  const Vec2 arm = make_box(Vec2::Zero(), 0.7, {0.5, 0.5}).arm[0];
  scene.cubes.push_back(sized_cube("tip", Vec2(0.2, 2.0) - arm, {0.5, 0.5}, 0.7));
  const FoundTouches f = find_touches(scene);
  ASSERT_EQ(f.touches.size(), 3U);
  const Touch& flush = f.touches[0];
  EXPECT_EQ(flush.kind, Touch::Kind::flush);
  EXPECT_EQ(flush.count, 2);
  EXPECT_EQ(flush.pair(), IndexPair(0, 1));
  EXPECT_NEAR(overlap_of(flush, f.contacts).length(), 1.0, 1e-15);
  const Touch& corner = f.touches[1];
  EXPECT_EQ(corner.kind, Touch::Kind::corner_on_side);
  EXPECT_EQ(corner.count, 1);
  EXPECT_EQ(f.contacts[corner.first].on, 2);
  const Touch& ground = f.touches[2];
  EXPECT_EQ(ground.kind, Touch::Kind::on_plane);
  EXPECT_EQ(ground.count, 2);
}

TEST(Touch, ContactsOfATouchAreThoseOfItsPair) {
  std::vector<SceneCube> cubes;
  for (int row = 0; row < 3; ++row) {
    for (int k = 0; k < 3; ++k)
      cubes.push_back(cube("c" + std::to_string(cubes.size()), {k + 0.5 * (row % 2), 0.5 + row}));
  }
  const FoundTouches f = find_touches(on_floor(cubes));
  int next = 0;
  for (const Touch& touch : f.touches) {
    EXPECT_EQ(touch.first, next);
    next += touch.count;
    for (int k = touch.first; k < next; ++k)
      EXPECT_EQ(IndexPair(std::minmax(f.contacts[k].on, f.contacts[k].from)), touch.pair());
  }
  EXPECT_EQ(next, static_cast<int>(f.contacts.size()));
  int touches = 0;
  for (const Island& island : find_islands(f.m.system, f.contacts, f.touches)) {
    for (const Touch& touch : island.touches) {
      ++touches;
      const Contact& c = island.contacts[touch.first];
      EXPECT_EQ(IndexPair(std::minmax(c.on, c.from)), touch.pair());
    }
  }
  EXPECT_EQ(touches, static_cast<int>(f.touches.size()));
}

TEST(Touch, OverlapIsSeenFromTheSideOfTheFirstContact) {
  for (const double shift : {-0.7, -0.2, 0.0, 0.3, 1.1}) {
    for (const double width : {0.5, 1.0, 2.0}) {
      const FoundTouches f = find_touches(
          on_floor({cube("a", {0.0, 0.5}), sized_cube("b", {shift, 1.5}, {width, 1.0})}));
      if (f.touches[0].kind != Touch::Kind::flush) continue;
      const double expected =
          std::min(0.5, shift + 0.5 * width) - std::max(-0.5, shift - 0.5 * width);
      const ContactSet rows = closed_rows(f, std::vector<char>(f.contacts.size(), 1));
      EXPECT_NEAR(overlap_of(rows.touches[0], rows.contacts).length(), expected, 1e-15);
    }
  }
}

TEST(Touch, ClosedFlushSidesHaveBothCornersOfTheShorterOne) {
  for (const double width : {0.5, 2.0}) {
    const FoundTouches f =
        find_touches(on_floor({cube("a", {0.0, 0.5}), sized_cube("b", {0.4, 1.5}, {width, 1.0})}));
    const ContactSet rows = closed_rows(f, std::vector<char>(f.contacts.size(), 1));
    ASSERT_EQ(rows.touches.size(), 2U);
    const Touch& touch = rows.touches[0];
    EXPECT_EQ(touch.kind, Touch::Kind::flush);
    const Contact& c = rows.contacts[touch.first];
    const Contact& d = rows.contacts[touch.first + 1];
    const int shorter = width < 1.0 ? 1 : 0;
    EXPECT_EQ(c.on, shorter);
    EXPECT_EQ(d.on, shorter);
    EXPECT_EQ(d.corner, next_corner(c.corner));
    EXPECT_EQ(d.side, c.side);
    EXPECT_NEAR(c.gap, 0.0, 1e-15);
    EXPECT_NEAR(d.gap, 0.0, 1e-15);
    EXPECT_LE(c.alpha, d.alpha) << "the first corner comes first along the side";
  }
}

TEST(Touch, OfWhichOneEndOpensIsOneAtACorner) {
  const FoundTouches f = find_touches(on_floor({cube("a", {0.0, 0.5}), cube("b", {0.4, 1.5})}));
  std::vector<char> closed(f.contacts.size(), 1);
  closed[0] = 0;
  closed[2] = 0;
  const ContactSet rows = closed_rows(f, closed);
  ASSERT_EQ(rows.touches.size(), 2U);
  EXPECT_EQ(rows.touches[0].kind, Touch::Kind::corner_on_side);
  EXPECT_EQ(rows.contacts[rows.touches[0].first].id(), f.contacts[1].id());
  EXPECT_EQ(rows.touches[1].kind, Touch::Kind::on_plane);
  EXPECT_EQ(rows.touches[1].count, 1);
  const ContactSet none = closed_rows(f, std::vector<char>(f.contacts.size(), 0));
  EXPECT_TRUE(none.touches.empty());
}

TEST(Touch, LoadsAreThoseOfTheLeverAtTheEndsOfTheOverlap) {
  //      +---b---+     sides [-0.1, 0.9] on [-0.5, 0.5]: one of the rows' corners is not above the
  //   +---a---+         other side, and its force stands for one at the end of the overlap
  const FoundTouches f = find_touches(on_floor({cube("a", {0.0, 0.5}), cube("b", {0.4, 1.5})}));
  const ContactSet rows = closed_rows(f, std::vector<char>(f.contacts.size(), 1));
  const Touch& touch = rows.touches[0];
  ASSERT_EQ(touch.kind, Touch::Kind::flush);
  std::vector<double> forces(rows.contacts.size(), 0.0);
  forces[touch.first] = 3.0;
  forces[touch.first + 1] = 1.0;
  std::vector<double> loads;
  find_loads(rows.touches, rows.contacts, forces, loads);
  ASSERT_EQ(loads.size(), 4U);
  // Sum and moment about the side's p_i stay the same.
  const Interval bears = overlap_of(touch, rows.contacts);
  const auto place = [&](int k) {
    const Contact& c = rows.contacts[touch.first + k];
    return c.alpha * c.length;
  };
  EXPECT_NEAR(loads[0] + loads[1], 4.0, 1e-14);
  EXPECT_NEAR(loads[0] * bears.low + loads[1] * bears.high, 3.0 * place(0) + place(1), 1e-14);
  EXPECT_NEAR(bears.length(), 0.6, 1e-15);
}

TEST(Touch, KnowsTheSurfaceOfItsPair) {
  Scene scene = on_floor({cube("a", {0.0, 0.5}), cube("b", {0.4, 1.5})});
  scene.cubes[0].material.friction = 0.4;
  scene.cubes[1].material.friction = 0.9;
  const FoundTouches f = find_touches(scene);
  EXPECT_NEAR(f.touches[0].surface.friction, 0.6, 1e-15);
  EXPECT_EQ(f.touches[1].surface.friction, 0.0);
}

}  // namespace
}  // namespace wuerfel::test
