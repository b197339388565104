// The paper's symbols and other labels: where they stand, and what they are made of.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "render/picture/compose_frame.h"
#include "render/picture/labels.h"
#include "tests/support/image_scenes.h"

namespace wuerfel::test {
namespace {

class Symbols : public ::testing::Test {
 protected:
  /// The corner of a turned cube above the middle of a side, as in Figure 5.
  static Snapshot corner_on_side() {
    Snapshot snapshot = two_cubes_snapshot();
    snapshot.sides.clear();
    snapshot.boxes[0].velocity = Vec2(0.0, 0.25);
    snapshot.contacts.push_back({Vec2(-0.5, 0.5), Vec2(0.5, 0.5), Vec2(0.25, 0.5), Vec2::UnitY(),
                                 Vec2(0.0, 0.3), Vec2(0.0, 0.5), Vec2(-0.4, 0.6), 1, 0});
    return snapshot;
  }
  DrawList compose(Layers layers) {
    options.layers = layers;
    view = literal_view(snapshot, style, options, 800, 450);
    return compose_frame(snapshot, view, style, options, font);
  }
  /// All that is written, from left to right as it was added.
  static std::string written(const DrawList& list) {
    std::string all;
    for (const TextShape& text : list.texts)
      all += text.text + " ";
    return all;
  }

  Snapshot snapshot = corner_on_side();
  Style style = make_style(Theme::light);
  FrameOptions options = literal_options(default_layers);
  View view;
  Font font;
};

TEST_F(Symbols, NameThePointsOfAContactAndItsShares) {
  const std::string all = written(compose({Layer::cubes, Layer::normals, Layer::symbols}));
  for (const char* wanted : {"p i", "p j", "p k", "α", "1 − α", "n", "w i,j", "w k"})
    EXPECT_NE(all.find(wanted), std::string::npos) << wanted << " in " << all;
  EXPECT_EQ(all.find("v "), std::string::npos) << "no velocities were asked for";
}

TEST_F(Symbols, SubscriptsAreSmallerAndLower) {
  const DrawList list = compose({Layer::cubes, Layer::symbols});
  const auto letter = std::ranges::find(list.texts, "p", &TextShape::text);
  ASSERT_NE(letter, list.texts.end());
  const TextShape& script = *(letter + 1);
  EXPECT_LT(script.size, 0.8F * letter->size);
  EXPECT_GT(script.baseline.y, letter->baseline.y);
  EXPECT_NEAR(
      script.baseline.x,
      static_cast<double>(letter->baseline.x) + font.width("p", static_cast<double>(letter->size)),
      1e-3);
}

TEST_F(Symbols, MakeVelocitiesThoseOfThePoints) {
  const auto tails = [&](Layers layers) {
    std::vector<Pixel> of;
    for (const DiscShape& disc : compose(layers).discs)
      of.push_back(disc.center);
    return of;
  };
  const auto at = [&](const Vec2& p) {
    const Vec2 pixel = view.to_pixel(p);
    return Pixel{static_cast<float>(pixel.x()), static_cast<float>(pixel.y())};
  };
  const auto of_points = tails({Layer::velocities, Layer::symbols});
  ASSERT_EQ(of_points.size(), 3U);
  EXPECT_EQ(of_points[0], at(snapshot.contacts[0].p_i));
  EXPECT_EQ(of_points[1], at(snapshot.contacts[0].p_j));
  EXPECT_EQ(of_points[2], at(snapshot.contacts[0].p_k));
  const auto of_centres = tails({Layer::velocities});
  ASSERT_EQ(of_centres.size(), 1U);
  EXPECT_EQ(of_centres[0], at(snapshot.boxes[0].center));
  const std::string all = written(compose({Layer::velocities, Layer::symbols}));
  for (const char* wanted : {"v i", "v j", "v k"})
    EXPECT_NE(all.find(wanted), std::string::npos) << wanted << " in " << all;
}

TEST_F(Symbols, TellTheSignsOfAreas) {
  snapshot = two_cubes_snapshot();
  const std::string all = written(compose({Layer::cubes, Layer::sides, Layer::symbols}));
  for (const char* wanted : {"A 1  > 0", "A 2  < 0", "A = 0"})
    EXPECT_NE(all.find(wanted), std::string::npos) << wanted << " in " << all;
}

TEST_F(Symbols, NameOneAreaByItsLetterAlone) {
  snapshot = two_cubes_snapshot();
  snapshot.sides.resize(1);
  const std::string all = written(compose({Layer::cubes, Layer::sides, Layer::symbols}));
  EXPECT_NE(all.find("A > 0"), std::string::npos) << all;
}

TEST_F(Symbols, TakeTheRoundingOfATouchingCornerForZero) {
  snapshot = two_cubes_snapshot();
  snapshot.sides.resize(1);
  SnapshotSide& side = snapshot.sides[0];
  side.area = -1e-12 * (side.p_j - side.p_i).squaredNorm();
  EXPECT_FALSE(is_negative(side));
  side.area *= 1e4;
  EXPECT_TRUE(is_negative(side));
}

TEST_F(Symbols, TellMassesAsSharesOfTheCube) {
  snapshot.boxes.resize(1);
  snapshot.boxes[0].mass = 3.0;
  snapshot.contacts.clear();
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5})
      snapshot.points.push_back({Vec2(x, y), 0.25});
  }
  snapshot.points.push_back({Vec2::Zero(), 2.0});
  const std::string all = written(compose({Layer::cubes, Layer::points, Layer::symbols}));
  EXPECT_EQ(all, "m/12 m/12 m/12 m/12 2m/3 ");
}

TEST_F(Symbols, OfManyContactsSayNothing) {
  snapshot.contacts.resize(9, snapshot.contacts[0]);
  const DrawList list = compose({Layer::cubes, Layer::symbols});
  EXPECT_TRUE(list.texts.empty());
  EXPECT_EQ(list.labels_left_out, 9) << "and that is told";
}

TEST_F(Symbols, LieOnNothingElse) {
  const DrawList list =
      compose({Layer::cubes, Layer::normals, Layer::velocities, Layer::symbols, Layer::hud});
  for (const TextShape& text : list.texts) {
    internal::Labels labels(view.width, view.height);
    for (const TextShape& other : list.texts)
      if (!(other == text)) labels.keep_off(internal::text_area(other, font));
    // A script touches its letter.
    const bool script = text.size < 0.75F * 1.15F * static_cast<float>(style.text_size * 0.62);
    DrawList scratch;
    TextShape moved = text;
    moved.size *= 0.5F;
    EXPECT_TRUE(script || labels.place(moved, std::span(&text.baseline, 1), font, scratch))
        << text.text;
  }
  EXPECT_EQ(list.labels_left_out, 0);
}

}  // namespace
}  // namespace wuerfel::test
