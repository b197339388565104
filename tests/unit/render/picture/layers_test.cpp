#include "render/picture/layers.h"

#include <gtest/gtest.h>

#include "render/picture/style.h"

namespace wuerfel::test {
namespace {

TEST(Layers, NameThemselvesInTheirOrder) {
  const Layers layers{Layer::grid, Layer::trails, Layer::cubes};
  EXPECT_EQ(to_string(layers), "cubes,trails,grid");
  EXPECT_EQ(to_string(Layers()), "");
}

TEST(Style, OfPrintIsGreyEvenWhereASceneAsksForColours) {
  const Style style = make_style(Theme::print);
  SnapshotBox box;
  box.color = {{255, 0, 0}};
  const Color color = body_color(style, box);
  EXPECT_EQ(color.r, color.g);
  EXPECT_EQ(color.g, color.b);
  EXPECT_GT(brightness(color), 0.6);
}

TEST(Style, ArrowColoursAreAbsentFromThePalette) {
  for (const Theme theme : {Theme::light, Theme::dark}) {
    const Style style = make_style(theme);
    for (const Color body : style.palette) {
      for (const ForceKind kind : {ForceKind::contact, ForceKind::friction}) {
        const Color arrow = force_color(style, kind);
        const int distance =
            std::abs(arrow.r - body.r) + std::abs(arrow.g - body.g) + std::abs(arrow.b - body.b);
        EXPECT_GT(distance, 90) << to_string(theme);
      }
    }
  }
}

}  // namespace
}  // namespace wuerfel::test
