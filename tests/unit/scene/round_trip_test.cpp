// normalised_scene and back; the shipped scenes.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "core/scene/overlap.h"
#include "tests/unit/scene/scene_texts.h"

namespace wuerfel::test {
namespace {

class ShippedScene : public ::testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] Scene scene() const {
    return parse_scene(shipped_scene_text(GetParam()), GetParam() + ".toml");
  }
};

TEST_P(ShippedScene, ComesBackFromItsNormalisedForm) {
  const Scene first = scene();
  const std::string json = normalised_scene(first);
  const Scene second = parse_scene(json, "normalised");
  EXPECT_EQ(second, first);
  EXPECT_EQ(normalised_scene(second), json) << "to the last bit";
}

TEST_P(ShippedScene, HasATitleAndAComment) {
  EXPECT_EQ(shipped_scene_text(GetParam()).substr(0, 2), "# ");
  EXPECT_FALSE(scene().title.empty());
}

TEST_P(ShippedScene, OverlapsNowhere) { EXPECT_FALSE(find_overlap(scene()).has_value()); }

INSTANTIATE_TEST_SUITE_P(Assets,
                         ShippedScene,
                         ::testing::ValuesIn(shipped_scene_names()),
                         [](const auto& scene) { return scene.param; });

TEST(ShippedScenes, AreTheOnesThatArePromised) {
  const std::vector<std::string> names = shipped_scene_names();
  for (const char* name : {"demo", "fig1_stack", "fig1_stack_stands", "fig2_rods", "fig3_sides",
                           "fig6_relative_motion", "fig7_masses", "ladder", "overhang_falls",
                           "overhang_stands", "pile", "pyramid", "tilted_drop", "tower", "wall"}) {
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  }
}

TEST(ShippedScenes, ThePyramidGrowsByOverride) {
  const Scene scene =
      parse_scene(shipped_scene_text("pyramid"), "pyramid.toml", {"pyramid.1.rows=40"});
  EXPECT_EQ(scene.cubes.size(), 820U);
}

TEST(ShippedScenes, TheLadderTouchesFloorAndWall) {
  const Scene scene = parse_scene(shipped_scene_text("ladder"), "ladder.toml");
  const SceneCube& ladder = scene.cubes.front();
  // Half the bounds of the turned ladder: 0.6 and 0.8 are cosine and sine of its angle.
  const Vec2 half(0.5 * (0.6 * ladder.size.x() + 0.8 * ladder.size.y()),
                  0.5 * (0.8 * ladder.size.x() + 0.6 * ladder.size.y()));
  EXPECT_NEAR(ladder.position.x() - half.x(), 0.0, 1e-15);
  EXPECT_NEAR(ladder.position.y() - half.y(), 0.0, 1e-15);
}

TEST(ShippedScenes, TheOverhangsAreHarmonicButForAThousandth) {
  for (const auto& [name, factor] :
       {std::pair{"overhang_stands", 0.999}, std::pair{"overhang_falls", 1.001}}) {
    const Scene scene = parse_scene(shipped_scene_text(name), name);
    ASSERT_EQ(scene.cubes.size(), 5U);
    double edge = 0.0;  // right edge of what carries, from the table upwards
    for (int k = 5; k >= 1; --k) {
      const SceneCube& cube = scene.cubes[static_cast<std::size_t>(5 - k)];
      const double right = cube.position.x() + 0.5;
      EXPECT_NEAR(right - edge, factor / (2.0 * k), 1e-15) << name << " " << cube.name;
      EXPECT_EQ(cube.position.y(), 5.5 - k);
      edge = right;
    }
  }
}

TEST(NormalisedScene, IsTheContractsJsonInOneFixedForm) {
  const Scene scene = parse_scene(
      "title = \"a \\\"b\\\" ü\"\nduration = 2.5\n[material]\nfriction = 0.5\n[[plane]]\nname = "
      "\"floor\"\n"
      "[[fixed]]\nposition = [9, 1]\nrestitution = 1\n"
      "[[tower]]\ncount = 1\non = \"floor\"\ncolor = \"orange\"\nfriction = 0\n"
      "[[pair]]\nbodies = [\"floor\", \"tower1_1\"]\nfriction = 0.1\n",
      "s.toml");
  EXPECT_EQ(
      normalised_scene(scene),
      R"({"version":1,"title":"a \"b\" ü","gravity":[0,-9.81],"duration":2.5,)"
      R"("material":{"friction":0.5,"restitution":0},)"
      R"("plane":[{"name":"floor","point":[0,0],"normal":[0,1]}],)"
      R"("fixed":[{"name":"fixed1","size":[1,1],"position":[9,1],"angle":0,"restitution":1}],)"
      R"("cube":[{"name":"tower1_1","size":[1,1],"mass":1,"position":[0,0.5],"angle":0,)"
      R"("velocity":[0,0],"spin":0,"friction":0,"color":"#e69f00"}],)"
      R"("pair":[{"bodies":["floor","tower1_1"],"friction":0.1}]})");
}

TEST(NormalisedScene, KeepsEveryBitOfEveryNumber) {
  Scene scene = parse_scene(
      "[[plane]]\nnormal = [-0.3, 0.7]\npoint = [0, -9e14]\n[[cube]]\nposition = [0, 1]\n",
      "s.toml");
  SceneCube& cube = scene.cubes[0];
  cube.position = {0.1 + 0.2, 1.0 / 3.0};
  cube.angle = std::numeric_limits<double>::denorm_min();
  cube.velocity = {-0.0, 123456789.012345678};
  cube.spin = -1e-300;
  cube.mass = 0x1.fffffffffffffp-50;
  const Scene back = parse_scene(normalised_scene(scene), "-");
  EXPECT_EQ(back, scene);
  EXPECT_TRUE(std::signbit(back.cubes[0].velocity.x()));
}

TEST(NormalisedScene, UnitNormalsOfAnyDirectionStayAsTheyAre) {
  for (int i = 0; i < 1000; ++i) {
    const double x = std::cos(0.37 * i);
    const double y = std::sin(0.37 * i);
    const std::string text = "[[plane]]\npoint = [" + std::to_string(-20.0 * x) + ", "
                             + std::to_string(-20.0 * y) + "]\nnormal = [" + std::to_string(5.0 * x)
                             + ", " + std::to_string(5.0 * y) + "]\n[[cube]]\nposition = [0, 0]\n";
    const Scene scene = parse_scene(text, "s.toml");
    EXPECT_EQ(parse_scene(normalised_scene(scene), "-"), scene);
  }
}

}  // namespace
}  // namespace wuerfel::test
