// Golden pictures of every theme and layer.
//
//   golden_test                   compares
//   golden_test --update-golden   stores what is drawn now and says what changed; look at it before committing
//   golden_test --print-hash      draws one picture and prints the hash of its pixels

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include <gtest/gtest.h>

#include "render/picture/film_strip.h"
#include "render/raster/compare.h"
#include "tests/golden/drawn.h"
#include "tests/support/image_golden.h"

namespace wuerfel::test {
namespace {

class ThemePicture : public ::testing::TestWithParam<Theme> {};

TEST_P(ThemePicture, LooksAsItDid) {
  const Image image = draw_fitted(pyramid_snapshot(), GetParam(), default_layers);
  EXPECT_TRUE(matches_golden("theme-" + std::string(to_string(GetParam())), image));
}

INSTANTIATE_TEST_SUITE_P(
    Golden,
    ThemePicture,
    ::testing::Values(Theme::light, Theme::dark, Theme::print, Theme::transparent),
    [](const auto& tested) { return std::string(to_string(tested.param)); });

struct LayerCase {
  std::string name;
  Layers layers;
};

class LayerPicture : public ::testing::TestWithParam<LayerCase> {};

TEST_P(LayerPicture, LooksAsItDid) {
  const bool sides = GetParam().layers.has(Layer::sides);
  const bool fails = GetParam().layers.has(Layer::causes) || GetParam().layers.has(Layer::mechanism)
                     || GetParam().layers.has(Layer::whiskers);
  const Snapshot snapshot = sides   ? two_cubes_snapshot()
                            : fails ? failing_snapshot()
                                    : pyramid_snapshot();
  EXPECT_TRUE(matches_golden("layer-" + GetParam().name,
                             draw_fitted(snapshot, Theme::light, GetParam().layers)));
}

INSTANTIATE_TEST_SUITE_P(
    Golden,
    LayerPicture,
    ::testing::Values(
        LayerCase{"cubes", {Layer::cubes}},
        LayerCase{"rods", {Layer::cubes, Layer::rods}},
        LayerCase{"points", {Layer::cubes, Layer::rods, Layer::points}},
        LayerCase{"sides", {Layer::cubes, Layer::sides, Layer::names}},
        LayerCase{"symbols", {Layer::cubes, Layer::sides, Layer::symbols}},
        LayerCase{"normals", {Layer::cubes, Layer::contacts, Layer::normals}},
        LayerCase{"forces", {Layer::forces}},
        LayerCase{"contact_forces", {Layer::cubes, Layer::contact_forces, Layer::hud}},
        LayerCase{"joints", {Layer::cubes, Layer::joints, Layer::forces, Layer::hud}},
        LayerCase{"thrust", {Layer::cubes, Layer::thrust, Layer::hud}},
        LayerCase{"whiskers", {Layer::cubes, Layer::forces, Layer::whiskers, Layer::hud}},
        LayerCase{"mechanism", {Layer::cubes, Layer::mechanism, Layer::hud}},
        LayerCase{"causes", {Layer::cubes, Layer::causes, Layer::hud}},
        LayerCase{"weights", {Layer::cubes, Layer::weights, Layer::values, Layer::hud}},
        LayerCase{"accelerations", {Layer::cubes, Layer::accelerations, Layer::hud}},
        LayerCase{"instances", {Layer::instances}},
        LayerCase{"rod_forces", {Layer::cubes, Layer::rod_forces, Layer::hud}},
        LayerCase{"velocities", {Layer::cubes, Layer::velocities, Layer::hud}},
        LayerCase{"trails", {Layer::cubes, Layer::trails}},
        LayerCase{"contacts", {Layer::cubes, Layer::contacts}},
        LayerCase{"grid", {Layer::cubes, Layer::grid}},
        LayerCase{"names", {Layer::cubes, Layer::names}},
        LayerCase{"hud", {Layer::hud}}),
    [](const auto& tested) { return tested.param.name; });

TEST(GoldenPicture, ShowsCubesTooSmallForFullLines) {
  Snapshot snapshot;
  snapshot.planes.push_back({"floor", Vec2::Zero(), Vec2::UnitY()});
  for (int i = 0; i < 900; ++i) {
    SnapshotBox box;
    const int row = i / 45;
    box.center = Vec2(i % 45 + 0.2 * (row % 2), 0.5 + 1.05 * row);
    box.angle = 0.01 * i;
    box.color_index = i;
    snapshot.boxes.push_back(box);
  }
  EXPECT_TRUE(matches_golden(
      "crowd", draw_fitted(snapshot, Theme::light, {Layer::cubes, Layer::rods, Layer::hud})));
}

TEST(GoldenPicture, GrowsTextAndLinesForHiDpi) {
  const Snapshot snapshot = pyramid_snapshot();
  FrameOptions options = literal_options(default_layers);
  options.scale = 2.0;
  const View view = literal_view(snapshot, make_style(Theme::light), options, width, height);
  EXPECT_TRUE(matches_golden("scale-2", draw(snapshot, view, Theme::light, options)));
}

TEST(GoldenPicture, MarksArrowsThatAreCutAndHidesSmallOnes) {
  Snapshot snapshot = pyramid_snapshot();
  snapshot.joints[0].force.y() = 100.0;  // at 0.04 m/N: longer than the longest, 0.8 m
  snapshot.joints[3].force.y() = 0.2;    // below the smallest, 0.3 N
  FrameOptions options = literal_options(default_layers);
  options.legend.insert(LegendEntry::cut);
  options.legend.insert(LegendEntry::hidden);
  const View view = literal_view(snapshot, make_style(Theme::light), options, width, height);
  EXPECT_TRUE(matches_golden("capped", draw(snapshot, view, Theme::light, options)));
}

TEST(GoldenPicture, ColoursByLoadWithAScale) {
  FrameOptions options = literal_options({Layer::cubes, Layer::hud});
  options.coloring = {ColorBy::load, 25.0};
  const Snapshot snapshot = pyramid_snapshot();
  const View view = literal_view(snapshot, make_style(Theme::light), options, width, height);
  EXPECT_TRUE(matches_golden("load", draw(snapshot, view, Theme::light, options)));
}

TEST(GoldenPicture, SetsBodiesFree) {
  FrameOptions options =
      literal_options({Layer::cubes, Layer::forces, Layer::weights, Layer::values});
  options.explode = 0.6;
  const Snapshot snapshot = pyramid_snapshot();
  const View view = fixed_view(Vec2(-0.5, 2.5), 12.0, width, height);
  EXPECT_TRUE(matches_golden("free", draw(snapshot, view, Theme::light, options)));
}

TEST(GoldenPicture, LaysAStripOut) {
  const Snapshot snapshot = pyramid_snapshot();
  const Style style = make_style(Theme::light);
  const StripLayout layout = strip_layout({3, 1}, width, 130, 1.0);
  const FrameOptions options = literal_options({Layer::cubes, Layer::forces});
  Image page;
  shared_renderer().draw(
      strip_page(std::vector<std::string>{"t = 0.000 s", "t = 0.500 s", "t = 1.000 s"}, layout,
                 style),
      page);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [x, y] = cell_place(layout, i);
    paste(draw(snapshot,
               literal_view(snapshot, style, options, layout.cell_width, layout.cell_height),
               Theme::light, options),
          x, y, page);
  }
  EXPECT_TRUE(matches_golden("strip", page));
}

TEST(Golden, MissingReferenceIsAFailure) {
  EXPECT_FALSE(matches_golden("no-such-picture", Image(4, 4)));
}

/// Runs this program again with a number of rasteriser threads and reads the hash that it prints.
std::string hash_with_threads(const std::string& threads) {
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string command = "LP_NUM_THREADS=" + threads + " '" + program + "' --print-hash";
  const std::unique_ptr<FILE, int (*)(FILE*)> output(popen(command.c_str(), "r"), pclose);
  std::array<char, 64> line{};
  return std::fgets(line.data(), static_cast<int>(line.size()), output.get()) == nullptr
             ? ""
             : line.data();
}

std::string printed_hash(const Image& image) { return std::to_string(pixel_hash(image)) + "\n"; }

TEST(Pixels, DoNotDependOnTheNumberOfThreads) {
  const std::string here =
      printed_hash(draw_fitted(pyramid_snapshot(), Theme::light, default_layers));
  for (const char* threads : {"0", "1", "2", "5"})
    EXPECT_EQ(hash_with_threads(threads), here) << threads;
}

TEST(Pixels, DoNotDependOnWhatWasDrawnBefore) {
  const Image first = draw_fitted(pyramid_snapshot(), Theme::light, default_layers);
  draw_fitted(two_cubes_snapshot(), Theme::transparent, {Layer::cubes, Layer::sides, Layer::hud});
  EXPECT_EQ(first, draw_fitted(pyramid_snapshot(), Theme::light, default_layers));
}

TEST(Pixels, DoNotDependOnTheSizeOfThePictureBefore) {
  const Image first = draw_fitted(pyramid_snapshot(), Theme::light, default_layers);
  const Style style = make_style(Theme::light);
  const FrameOptions options = literal_options({Layer::cubes, Layer::forces});
  for (const auto& [w, h] : {std::pair{150, 90}, {148, 98}, {480, 130}, {960, 540}}) {
    for (int times = 0; times < 3; ++times) {
      draw(pyramid_snapshot(), literal_view(pyramid_snapshot(), style, options, w, h), Theme::light,
           options);
    }
    EXPECT_EQ(first, draw_fitted(pyramid_snapshot(), Theme::light, default_layers))
        << w << 'x' << h;
  }
}

/// What the arguments beside GoogleTest's ask for; -1: run the tests.
int run_mode(std::string_view argument) {
  if (argument == "--print-hash") {
    std::cout << printed_hash(draw_fitted(pyramid_snapshot(), Theme::light, default_layers));
    return EXIT_SUCCESS;
  }
  if (argument == "--update-golden") {
    update_golden(shared_renderer().description());
    // Only the pictures: what proves the comparison has nothing to store.
    ::testing::GTEST_FLAG(filter) = "Golden/*:GoldenPicture.*";
    return -1;
  }
  std::cerr << "unknown argument " << argument << '\n';
  return EXIT_FAILURE;
}

}  // namespace
}  // namespace wuerfel::test

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  for (int i = 1; i < argc; ++i) {
    const int status = wuerfel::test::run_mode(argv[i]);
    if (status >= 0) return status;
  }
  return RUN_ALL_TESTS();
}
