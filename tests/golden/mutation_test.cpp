// Proof that the comparison of pictures catches what it should.
#include <utility>

#include <gtest/gtest.h>

#include "render/raster/compare.h"
#include "tests/golden/drawn.h"

namespace wuerfel::test {
namespace {

/// A picture with one thing changed, drawn in the same view.
class Mutation : public ::testing::Test {
 protected:
  Mutation()
      : options(literal_options({Layer::cubes, Layer::rods, Layer::forces})),
        view(literal_view(snapshot, make_style(Theme::light), options, width, height)),
        original(draw(snapshot, view, Theme::light, options)) {}

  CompareVerdict verdict() const {
    return compare_images(original, draw(snapshot, view, Theme::light, options)).verdict;
  }
  double pixel() const { return 1.0 / view.pixels_per_metre; }

  Snapshot snapshot = pyramid_snapshot();
  FrameOptions options;
  View view;
  Image original;
};

TEST_F(Mutation, NothingChangedIsIdentical) { EXPECT_EQ(verdict(), CompareVerdict::identical); }

TEST_F(Mutation, MissingArrowIsCaught) {
  snapshot.joints.pop_back();
  EXPECT_EQ(verdict(), CompareVerdict::different);
}

TEST_F(Mutation, ArrowOnePixelAsideIsCaught) {
  snapshot.joints.front().point.x() += pixel();
  EXPECT_EQ(verdict(), CompareVerdict::different);
}

TEST_F(Mutation, ArrowOnePixelLongerIsCaught) {
  snapshot.joints.front().force.y() += pixel() / options.force_scale.metres_per_newton;
  EXPECT_EQ(verdict(), CompareVerdict::different);
}

TEST_F(Mutation, SwappedColoursAreCaught) {
  std::swap(snapshot.boxes[0].color_index, snapshot.boxes[1].color_index);
  EXPECT_EQ(verdict(), CompareVerdict::different);
}

TEST_F(Mutation, MissingCubeIsCaught) {
  snapshot.boxes.erase(snapshot.boxes.begin() + 6);
  EXPECT_EQ(verdict(), CompareVerdict::different);
}

TEST_F(Mutation, MissingRodIsCaught) {
  snapshot.rods.erase(snapshot.rods.begin() + 1);
  EXPECT_EQ(verdict(), CompareVerdict::different);
}

TEST_F(Mutation, CubeTurnedByHalfADegreeIsCaught) {
  snapshot.boxes[6].angle += 0.5 * 3.14159265 / 180.0;
  EXPECT_EQ(verdict(), CompareVerdict::different);
}
}  // namespace
}  // namespace wuerfel::test
