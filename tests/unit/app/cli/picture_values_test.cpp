#include "app/cli/picture_values.h"

#include <string>

#include <gtest/gtest.h>

#include "app/cli/exit_code.h"

namespace wuerfel::test {
namespace {

std::string complaint_about_layers(const std::string& text) {
  try {
    parse_layers(text);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(ParseLayers, TakesNamesWithCommas) {
  const Layers layers = parse_layers("cubes, rod-forces,hud");
  EXPECT_EQ(layers, (Layers{Layer::cubes, Layer::rod_forces, Layer::hud}));
  EXPECT_FALSE(layers.has(Layer::forces));
}

TEST(ParseLayers, UnderstandsWhatASetOfLayersCallsItself) {
  const Layers layers{Layer::grid, Layer::trails, Layer::cubes};
  EXPECT_EQ(parse_layers(to_string(layers)), layers);
}

TEST(ParseLayers, MakesNoLayersOfNoNames) { EXPECT_EQ(parse_layers(""), Layers()); }

TEST(ParseLayers, RefusesCommasWithNothingBesideThem) {
  for (const char* text : {"cubes,,forces", ",cubes", "cubes,", "cubes, ,forces", ",", " ,"}) {
    const std::string complaint = complaint_about_layers(text);
    EXPECT_NE(complaint.find("a comma too many"), std::string::npos) << text << ": " << complaint;
  }
  EXPECT_THROW(parse_legend("contact,,cut"), UsageError);
  EXPECT_EQ(parse_layers(" "), Layers());
}

TEST(ParseLayers, SuggestsTheNearestName) {
  EXPECT_EQ(complaint_about_layers("cubes,froces"),
            "unknown layer 'froces'; did you mean \"forces\"?");
}

TEST(ParseLayers, ListsAllNamesWhereNoneIsNear) {
  EXPECT_NE(complaint_about_layers("shadows").find("known: cubes, rods, points"),
            std::string::npos);
}

TEST(ParseTheme, UnderstandsEveryThemesName) {
  for (const Theme theme : {Theme::light, Theme::dark, Theme::print, Theme::transparent})
    EXPECT_EQ(parse_theme(to_string(theme)), theme);
  EXPECT_THROW(parse_theme("drak"), UsageError);
}

TEST(ParseStrip, TakesColumnsByRowsAndNothingElse) {
  EXPECT_EQ(parse_strip("4x2").columns, 4);
  EXPECT_EQ(parse_strip("4x2").rows, 2);
  for (const char* text :
       {"", "4", "4x", "x2", "0x2", "4x0", "-1x2", "4x2x1", "4 x2", "65536x65536", "2147483647x2"})
    EXPECT_THROW(parse_strip(text), UsageError) << text;
}

TEST(ParseWindow, TakesCentreAndWidth) {
  const WorldWindow window = parse_window("1,2.5,8");
  EXPECT_EQ(window.center, Vec2(1.0, 2.5));
  EXPECT_EQ(window.width, 8.0);
}

TEST(ParseWindow, RefusesWhatShowsNoPartOfTheWorld) {
  for (const char* text : {"", "1,2", "1,2,0", "1,2,-3", "1,2,3,4", "a,b,c", "1;2;3", "1,2,nan",
                           "inf,0,1", "1,2,3 "}) {
    EXPECT_THROW(parse_window(text), UsageError) << text;
  }
}

}  // namespace
}  // namespace wuerfel::test
