// What a frame is made of, looked at in the draw list: no pixel is drawn here.
#include "render/picture/compose_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "render/picture/explode.h"
#include "render/picture/labels.h"
#include "render/raster/renderer.h"
#include "tests/unit/render/picture/composition.h"

namespace wuerfel::test {
namespace {

TEST_F(Composition, NamesThatDoNotFitAreLeftOutAndCounted) {
  snapshot.boxes[0].name = std::string(60, 'x');
  const DrawList list = compose({Layer::cubes, Layer::names});
  EXPECT_TRUE(std::ranges::none_of(
      list.texts, [](const TextShape& text) { return text.text.starts_with("xx"); }));
  EXPECT_GE(list.labels_left_out, 1);
}

TEST_F(Composition, NamesOfThinBodiesStandBesideThem) {
  SnapshotBox plank = snapshot.boxes[0];
  plank.name = "plank";
  plank.size = Vec2(2.0, 0.02);
  plank.center = Vec2(0.0, 4.0);
  SnapshotBox above = plank;  // leaves no room between
  above.name = "other";
  above.center.y() += 0.1;
  snapshot.boxes = {plank, above};
  snapshot.rods.clear();
  const DrawList list = compose({Layer::cubes, Layer::names});
  const double at = view.to_pixel(plank.center).y();
  const auto baseline = [&](std::string_view name) {
    const auto text = std::ranges::find(list.texts, name, &TextShape::text);
    return text == list.texts.end() ? at : static_cast<double>(text->baseline.y);
  };
  EXPECT_GT(baseline("plank"), at + 6.0) << "below, where its neighbour is not";
  EXPECT_LT(baseline("other"), at - 6.0);
  EXPECT_EQ(list.labels_left_out, 0);
}

TEST_F(Composition, LayerThatIsOffLeavesNothing) {
  EXPECT_TRUE(compose({Layer::forces}).boxes.empty());
  EXPECT_TRUE(compose({Layer::cubes}).arrows.empty());
  EXPECT_TRUE(compose({Layer::cubes}).texts.empty());
  EXPECT_TRUE(compose({Layer::cubes}).discs.empty());
  EXPECT_TRUE(compose({}).runs.empty());
}

TEST_F(Composition, RodsThatAreNotListedAreDiagonals) {
  snapshot.rods.clear();
  const DrawList list = compose({Layer::cubes, Layer::rods});
  EXPECT_EQ(std::ranges::count_if(list.boxes,
                                  [](const BoxShape& box) { return box.diagonal_width > 0.0F; }),
            8)
      << "one for each cube, none for the shelf and the ground";
}

TEST_F(Composition, MassesHaveAreasProportionalToThem) {
  snapshot.points = {{Vec2(0.0, 0.0), 4.0}, {Vec2(1.0, 0.0), 1.0}};
  const DrawList list = compose({Layer::points});
  ASSERT_EQ(list.discs.size(), 2U);
  const float border = list.discs[0].outline_width;
  EXPECT_NEAR((list.discs[0].radius - border) / (list.discs[1].radius - border), 2.0, 1e-4);
}

TEST_F(Composition, TrianglesOfEquation2ShowTheirSign) {
  snapshot = two_cubes_snapshot();
  const DrawList list = compose({Layer::sides});
  ASSERT_EQ(list.triangles.size(), 2U);
  EXPECT_EQ(list.triangles[0].outline, style.positive_side);
  EXPECT_EQ(list.triangles[1].outline, style.negative_side);
  EXPECT_EQ(std::ranges::count(list.segments, style.positive_side, &SegmentShape::color), 1)
      << "the flat one is a line";
  EXPECT_GT(std::ranges::count(list.segments, style.negative_side, &SegmentShape::color), 1)
      << "the negative one is hatched";
}

TEST_F(Composition, GridEndsHoweverFarOutTheViewIs) {
  for (const double distance : {1e6, 1e12, 1e15, 1e16, 1e100, 1e300}) {
    for (const double width : {1e-300, 1e-3, 1.0, 1e300}) {
      options.layers = {Layer::grid, Layer::cubes};
      view = fixed_view(Vec2(distance, -distance), width, 640, 360);
      EXPECT_LT(compose_frame(snapshot, view, style, options, font).segments.size(), 2000U)
          << distance << ' ' << width;
    }
  }
}

TEST_F(Composition, GridHasALineAtEveryHalfMetreThatIsSeen) {
  options.layers = {Layer::grid};
  view = fixed_view(Vec2(1e6, 0.0), 6.4, 640, 360);
  const DrawList list = compose_frame(snapshot, view, style, options, font);
  EXPECT_EQ(list.segments.size(), 13U + 7U);
}

TEST_F(Composition, ContactsAndPointsArePaintedOverArrows) {
  const DrawList list =
      compose({Layer::cubes, Layer::forces, Layer::contacts, Layer::points, Layer::normals});
  const auto start = [&](std::string_view name) {
    const auto group = std::ranges::find(list.groups, name, &ShapeGroup::name);
    EXPECT_NE(group, list.groups.end()) << name;
    return group->shape;
  };
  EXPECT_LT(start("arrows"), start("contacts"));
  EXPECT_LT(start("arrows"), start("points"));
}

TEST(BodyColors, TellLoadsSpeedsAndIslands) {
  Snapshot snapshot = pyramid_snapshot();
  const Style style = make_style(Theme::light);
  const auto loads_of = loads(snapshot);
  EXPECT_DOUBLE_EQ(loads_of[1], 20.0);
  EXPECT_DOUBLE_EQ(loads_of[3], 14.0);
  const auto by_load = body_colors(snapshot, style, {ColorBy::load, 40.0});
  EXPECT_EQ(by_load[1], scale_color(style, 0.5));
  EXPECT_EQ(by_load[8], style.fixed) << "the shelf bears nothing";
  const auto by_speed = body_colors(snapshot, style, {ColorBy::speed, 0.0});
  EXPECT_EQ(by_speed[0], scale_color(style, 0.0));
  EXPECT_EQ(by_speed[6], scale_color(style, 1.0)) << "the fastest";
  const auto by_island = body_colors(snapshot, style, {ColorBy::island, 0.0});
  EXPECT_EQ(by_island[0], by_island[5]);
  EXPECT_EQ(by_island[6], style.palette[6]);
}

TEST_F(Composition, NamesOfPointsStandBesideThem) {
  snapshot.masses.push_back({"bob", Vec2(3.5, 3.0), 1.0});
  const DrawList list = compose({Layer::cubes, Layer::names});
  const auto name = std::ranges::find(list.texts, "bob", &TextShape::text);
  ASSERT_NE(name, list.texts.end());
  const double at = view.to_pixel(snapshot.masses[0].position).x();
  const double aside = std::abs(static_cast<double>(name->baseline.x) - at);
  EXPECT_GT(aside, 3.0) << "not on the disc";
  EXPECT_LT(aside, 60.0);
  const DrawList plain = compose({Layer::cubes});
  EXPECT_EQ(std::ranges::find(plain.texts, "bob", &TextShape::text), plain.texts.end());
}

TEST(Exploded, RodsPinsAndPointsGoWithTheirBodies) {
  Snapshot snapshot;
  snapshot.boxes.resize(2);
  snapshot.boxes[0].name = "a";
  snapshot.boxes[1].name = "b";
  snapshot.boxes[1].center = Vec2(2.0, 0.0);
  snapshot.masses.push_back({"m", Vec2(1.0, 3.0), 1.0});
  const Vec2 pull(0.0, -4.0);
  snapshot.links.push_back({"rod", false, Vec2(0.5, 0.5), Vec2(1.0, 3.0), {"a", "m"}, -pull, 4.0});
  snapshot.links.push_back(
      {"pin", true, Vec2(1.0, 0.0), Vec2(1.0, 0.0), {"a", "b"}, Vec2(1.0, 0.0), 0.0});
  for (const double x : {-0.5, 0.5, 1.5, 2.5}) {
    snapshot.points.push_back({Vec2(x, -0.5), 0.5});
    snapshot.rods.push_back({Vec2(x, -0.5), Vec2(x, 0.5), 0.0});
  }
  const Snapshot apart = exploded(snapshot, 1.0);
  const Vec2 way_a = apart.boxes[0].center - snapshot.boxes[0].center;
  const Vec2 way_b = apart.boxes[1].center - snapshot.boxes[1].center;
  const Vec2 way_m = apart.masses[0].position - snapshot.masses[0].position;
  EXPECT_GT((way_b - way_a).x(), 1.9);
  EXPECT_EQ(apart.links[0].a, snapshot.links[0].a + way_a);
  EXPECT_EQ(apart.links[0].b, snapshot.links[0].b + way_m);
  EXPECT_EQ(apart.links[1].a, snapshot.links[1].a + way_a);
  EXPECT_EQ(apart.links[1].b, snapshot.links[1].b + way_b);
  EXPECT_EQ(apart.points[1].position, snapshot.points[1].position + way_a);
  EXPECT_EQ(apart.points[2].position, snapshot.points[2].position + way_b);
  EXPECT_EQ(apart.rods[3].b, snapshot.rods[3].b + way_b);
  ASSERT_EQ(apart.forces.size(), 4U) << "both of each pair";
  Vec2 sum = Vec2::Zero();
  for (const SnapshotForce& force : apart.forces)
    sum += force.force;
  EXPECT_TRUE(sum.isZero(0.0));
}

TEST_F(Composition, GhostsLieBelowTheBodiesAndOnlyWhereTheyMoved) {
  snapshot.ghosts = {snapshot.boxes[6], snapshot.boxes[0]};
  snapshot.ghosts[0].center.y() += 1.0;
  const DrawList list = compose({Layer::cubes});
  EXPECT_EQ(list.boxes.size(), 2U + 1U + 9U) << "two planes, a ghost, the bodies";
  EXPECT_LT(list.boxes[2].fill.a, 100);
}

TEST_F(Composition, InstanceMasksAreNumbersAndWholePixels) {
  snapshot.boxes.resize(400, snapshot.boxes[1]);
  snapshot.boxes.back().center = Vec2(2.0, 0.5);
  Renderer renderer;
  Image image;
  options.layers = {Layer::instances};
  view = literal_view(snapshot, style, options, 320, 180);
  renderer.draw(compose_frame(snapshot, view, style, options, font), image);
  const Vec2 middle = view.to_pixel(Vec2(2.0, 0.5));
  const Color color = image.at(static_cast<int>(middle.x()), static_cast<int>(middle.y()));
  EXPECT_EQ(color.r + 256 * color.g + 65536 * color.b, 400);
  int covered = 0;
  for (int y = 0; y < 180; ++y) {
    for (int x = 0; x < 320; ++x) {
      const Color at = image.at(x, y);
      const int id = at.r + 256 * at.g;
      ASSERT_LE(id, 400);
      covered += id == 400 ? 1 : 0;
    }
  }
  const double side = view.pixels_per_metre;
  EXPECT_NEAR(covered, side * side, 2.0 * side) << "no antialiasing";
}

// As long as the difference of two arrows, and beside the one that is drawn.

TEST_F(Composition, ThinBodiesAreDrawnAsWideAsALine) {
  snapshot.boxes.resize(1);
  snapshot.boxes[0].size = {2.0, 1e-6};
  const DrawList list = compose({Layer::cubes});
  ASSERT_EQ(list.bodies.size(), 1U);
  const BoxShape& rod = list.boxes[list.bodies[0].box];
  EXPECT_FLOAT_EQ(rod.half_size.y, 0.9F * 0.62F);
  EXPECT_FLOAT_EQ(rod.half_size.x, static_cast<float>(view.pixels_per_metre));
}

TEST_F(Composition, AnAccelerationAlongTheVelocityStandsBesideIt) {
  snapshot.boxes.resize(1);
  options.metres_per_speed = options.metres_per_acceleration = 0.1;
  const auto shafts = [&](const Vec2& velocity) {
    snapshot.boxes[0].velocity = velocity;
    snapshot.boxes[0].acceleration = {0.0, -9.81};
    const DrawList list = compose({Layer::velocities, Layer::accelerations});
    std::vector<float> places;
    for (const SegmentShape& s : list.segments)
      if (is_upright(s) && s.color != style.halo) places.push_back(s.from.x);
    return places;
  };
  const std::vector<float> along = shafts({0.0, -2.0});
  ASSERT_EQ(along.size(), 2U);
  EXPECT_GT(std::abs(along[0] - along[1]), 5.0F * 0.62F);
  const std::vector<float> against = shafts({0.0, 2.0});
  ASSERT_EQ(against.size(), 2U);
  EXPECT_EQ(against[0], against[1]);
}

TEST_F(Composition, WhiskersWithoutAnEndAreOpenLikeThoseThatAreTooLong) {
  snapshot = failing_snapshot();
  const Layers layers{Layer::cubes, Layer::forces, Layer::whiskers};
  const DrawList too_long = compose(layers);
  snapshot.joints[4].range->most = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(compose(layers).segments == too_long.segments);
}

}  // namespace
}  // namespace wuerfel::test
