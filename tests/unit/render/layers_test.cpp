#include "render/layers.h"

#include <string>

#include <gtest/gtest.h>

#include "render/error.h"
#include "render/style.h"

namespace wuerfel {
namespace {

std::string message_of(const std::string& text) {
  try {
    parse_layers(text);
  } catch (const RenderError& error) {
    return error.what();
  }
  return "";
}

TEST(Layers, AreParsedFromNamesWithCommas) {
  const Layers layers = parse_layers("cubes, rod-forces,hud");
  EXPECT_EQ(layers, (Layers{Layer::cubes, Layer::rod_forces, Layer::hud}));
  EXPECT_FALSE(layers.has(Layer::forces));
}

TEST(Layers, NameThemselvesSoThatParsingGivesThemBack) {
  const Layers layers{Layer::grid, Layer::trails, Layer::cubes};
  EXPECT_EQ(to_string(layers), "cubes,trails,grid");
  EXPECT_EQ(parse_layers(to_string(layers)), layers);
}

TEST(Layers, OfNoNamesAreEmpty) { EXPECT_EQ(parse_layers(""), Layers()); }

TEST(Layers, UnknownNameIsAnErrorThatSuggestsTheNearest) {
  EXPECT_EQ(message_of("cubes,froces"), "unknown layer 'froces', did you mean 'forces'?");
}

TEST(Layers, UnknownNameLikeNoOtherListsAll) {
  EXPECT_NE(message_of("shadows").find("known: cubes, rods, points"), std::string::npos);
}

TEST(Theme, NamesAreParsedAndWrongOnesGetASuggestion) {
  for (const Theme theme : {Theme::light, Theme::dark, Theme::print, Theme::transparent}) {
    EXPECT_EQ(parse_theme(to_string(theme)), theme);
  }
  EXPECT_THROW(parse_theme("drak"), RenderError);
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
}  // namespace wuerfel
