// Rules of the contact manifold: what touches, where, and with which normal.
#include "core/constraints/contact.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/constraints/manifold.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

struct Found {
  std::vector<Contact> contacts;
  double overlap = 0.0;
};

Found find(const Scene& scene) {
  const System system = make_system(scene);
  ContactFinder finder;
  Found found;
  found.contacts = finder.find(system, initial_state(scene));
  found.overlap = finder.deepest().depth;
  return found;
}

TEST(Contact, ACubeOnAPlaneTouchesWithItsTwoLowerCorners) {
  Scene scene = on_floor({});
  scene.cubes.push_back(cube("a", {3.0, 0.5}));
  const Found found = find(scene);
  ASSERT_EQ(found.contacts.size(), 2U);
  for (const Contact& c : found.contacts) {
    EXPECT_EQ(c.on, 0);
    EXPECT_EQ(c.from, 1);
    EXPECT_EQ(c.normal, Vec2(0.0, 1.0));
    EXPECT_EQ(c.point.y(), 0.0);
    // p_i and p_j lie around the corner so that Eq. (5) holds.
    EXPECT_NEAR((c.alpha * c.arm_j + (1.0 - c.alpha) * c.arm_i - c.point).norm(), 0.0, 1e-15);
    EXPECT_NEAR((perp(c.arm_j - c.arm_i) - c.length * c.normal).norm(), 0.0, 1e-15);
  }
}

TEST(Contact, FaceOnFaceTouchesAtTheEndsOfTheOverlap) {
  Scene scene;
  scene.cubes = {cube("a", {0.0, 0.5}), cube("b", {0.3, 1.5})};
  const Found found = find(scene);
  ASSERT_EQ(found.contacts.size(), 2U);
  // Left end: the corner of b on the top of a; right end: the corner of a under b.
  EXPECT_EQ(found.contacts[0].point, Vec2(-0.2, 1.0));
  EXPECT_EQ(found.contacts[0].on, 1);
  EXPECT_EQ(found.contacts[1].point, Vec2(0.5, 1.0));
  EXPECT_EQ(found.contacts[1].on, 0);
  EXPECT_NEAR(found.contacts[0].alpha, 0.3, 1e-15);
  EXPECT_NEAR(found.contacts[1].alpha, 0.3, 1e-15);
}

TEST(Contact, AlphaAndArmsSatisfyEquation5ForTurnedCubes) {
  Scene scene;
  scene.cubes = {sized_cube("a", {0.0, 0.0}, {2.0, 1.0}, 0.3),
                 sized_cube("b", Vec2::Zero(), {0.5, 0.5}, 1.1)};
  // b stands on its corner on the upper side of a.
  const Box a = make_box(Vec2::Zero(), 0.3, {2.0, 1.0});
  const Box b = make_box(Vec2::Zero(), 1.1, {0.5, 0.5});
  const Vec2 target = 0.5 * a.normal(2) + 0.4 * a.axis;
  int lowest = 0;
  for (int k = 1; k < 4; ++k) {
    if (a.normal(2).dot(b.corner(k)) < a.normal(2).dot(b.corner(lowest))) lowest = k;
  }
  scene.cubes[1].position = target - b.corner(lowest);
  const Found found = find(scene);
  ASSERT_EQ(found.contacts.size(), 1U);
  const Contact& c = found.contacts[0];
  EXPECT_EQ(c.on, 1);
  EXPECT_EQ(c.side, 2);
  EXPECT_NEAR((c.alpha * c.arm_j + (1.0 - c.alpha) * c.arm_i - c.point).norm(), 0.0, 1e-14);
  EXPECT_NEAR((perp(c.arm_j - c.arm_i) / c.length - c.normal).norm(), 0.0, 1e-14);
  EXPECT_NEAR(c.alpha, 0.7, 1e-14);
}

TEST(Contact, AlignedCornersOfAGridTouchAcrossNoDiagonal) {
  Scene scene;
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 2; ++column) {
      scene.cubes.push_back(cube(std::string(1, static_cast<char>('a' + 2 * row + column)),
                                 {column + 0.5, row + 0.5}));
    }
  }
  // Four shared faces, two ends each; the diagonal pairs share a corner only.
  EXPECT_EQ(find(scene).contacts.size(), 8U);
}

TEST(Contact, AlignedCornersThatGoIntoEachOtherTouchOnTheSideThatClosesMoreSlowly) {
  Scene scene;
  scene.cubes.push_back(cube("low", {0.0, 0.0}));
  scene.cubes.push_back(cube("high", {1.0, 1.0}));
  scene.cubes[1].velocity = {-2.0, -1.0};
  const Found found = find(scene);
  ASSERT_EQ(found.contacts.size(), 1U);
  EXPECT_EQ((found.contacts[0].point - Vec2(0.5, 0.5)).norm(), 0.0);
  EXPECT_EQ(std::abs(found.contacts[0].normal.y()), 1.0);
  // What slides past, or opens, meets nobody.
  for (const Vec2& past : {Vec2(0.0, -1.0), Vec2(1.0, -1.0), Vec2(0.0, 0.0)}) {
    scene.cubes[1].velocity = past;
    EXPECT_TRUE(find(scene).contacts.empty());
  }
}

TEST(Contact, SidesAreFlushWhereBothCornersOfEitherTouch) {
  // The high cube has turned by so little that both ends of the overlap touch, and by so much that
  // its far corner, which has nothing below it, does not.
  constexpr double turn = 2e-10;
  constexpr double depth = 1e-10;
  Scene scene;
  scene.cubes.push_back(sized_cube("plank", {0.0, 0.0}, {2.0, 0.2}));
  scene.cubes.push_back(
      sized_cube("high", {1.5 - 0.5 * turn, 0.6 + turn - depth}, {2.0, 1.0}, turn));
  const Found found = find(scene);
  ASSERT_EQ(found.contacts.size(), 2U);
  EXPECT_NEAR(found.contacts[0].gap, -depth, 1e-15);
  EXPECT_NEAR(found.contacts[1].gap, 0.5 * turn - depth, 1e-15);
}

TEST(Contact, CornerOnCornerTakesTheSideThatOpensFaster) {
  const double half = std::sqrt(0.5);
  Scene scene;
  scene.cubes = {sized_cube("a", {0.0, half}, Vec2::Ones(), 0.25 * 3.14159265358979323846),
                 sized_cube("b", {0.0, 3.0 * half}, Vec2::Ones(), 0.25 * 3.14159265358979323846)};
  scene.cubes[1].velocity = {1.0, 0.0};
  const Found found = find(scene);
  ASSERT_EQ(found.contacts.size(), 0U) << "parallel sides with no overlap";
  scene.cubes[1].angle = 0.7;
  const Box b = make_box(Vec2::Zero(), 0.7, Vec2::Ones());
  double lowest = 0.0;
  Vec2 corner = Vec2::Zero();
  for (int k = 0; k < 4; ++k) {
    if (b.corner(k).y() < lowest) {
      lowest = b.corner(k).y();
      corner = b.corner(k);
    }
  }
  scene.cubes[1].position = Vec2(0.0, 2.0 * half) - corner;
  const Found turned = find(scene);
  ASSERT_EQ(turned.contacts.size(), 1U);
  const Contact& c = turned.contacts[0];
  const System system = make_system(scene);
  const State state = initial_state(scene);
  EXPECT_EQ(contact_motion(system, state, c), ContactMotion::opening);
  EXPECT_GT(gap_rate(c, contact_velocity(system, state, c)), 0.6);
}

TEST(Contact, ToleranceIsRelativeToTheSmallerSide) {
  for (const double size : {1e-6, 1.0, 1e6}) {
    Scene scene = on_floor({});
    scene.cubes.push_back(sized_cube("a", {0.0, 0.5 * size + 0.5e-9 * size}, {size, size}));
    EXPECT_EQ(find(scene).contacts.size(), 2U) << size;
    scene.cubes[0].position.y() = 0.5 * size + 2e-9 * size;
    EXPECT_EQ(find(scene).contacts.size(), 0U) << size;
    scene.cubes[0].position.y() = 0.5 * size - 1e-3 * size;
    EXPECT_NEAR(find(scene).overlap, 1e-3 * size, 1e-12 * size);
  }
}

TEST(Contact, MotionOfTheGapIsClosingRestingOrOpening) {
  Scene scene = on_floor({});
  scene.cubes.push_back(cube("a", {0.0, 0.5}));
  const System system = make_system(scene);
  const Found found = find(scene);
  for (const auto& [vy, expected] :
       {std::pair{-1e-8, ContactMotion::closing}, std::pair{0.0, ContactMotion::resting},
        std::pair{1e-10, ContactMotion::resting}, std::pair{1e-8, ContactMotion::opening}}) {
    scene.cubes[0].velocity = {0.0, vy};
    EXPECT_EQ(contact_motion(system, initial_state(scene), found.contacts[0]), expected) << vy;
  }
}

TEST(SeparatingSide, IsTheOneWhoseGapClosesLast) {
  // A square flies towards another from the upper right, so that it meets the right side first by
  // its line and last by its length: it lands beside it, not on it.
  const Box still = make_box({0.0, 0.0}, 0.0, {1.0, 1.0});
  const auto side = [&](const Vec2& from, const Vec2& to) {
    const std::vector<Box> start = {still, make_box(from, 0.0, {1.0, 1.0})};
    const std::vector<Box> end = {still, make_box(to, 0.0, {1.0, 1.0})};
    System system;
    system.bodies.resize(2);
    system.cubes = 2;
    const FacingSide found = separating_side(system, {start, end, end}, 0.0, 0, 1);
    const Box& box = (found.from == 0 ? start : end)[static_cast<std::size_t>(found.from)];
    return Vec2(found.from == 0 ? box.normal(found.side) : Vec2(-box.normal(found.side)));
  };
  // Above by 0.1 and beside by 0.3 at first; the wider gap closes last.
  EXPECT_EQ(side({1.3, 1.1}, {0.9, 0.9}), Vec2::UnitX());
  EXPECT_EQ(side({1.1, 1.3}, {0.9, 0.9}), Vec2::UnitY());
  // The nearer gap stays: it is the one that separates all the way.
  EXPECT_EQ(side({1.01, 1.3}, {1.01, 0.5}), Vec2::UnitX());
}

}  // namespace
}  // namespace wuerfel::test
