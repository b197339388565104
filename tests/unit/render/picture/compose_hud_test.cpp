// Title, time, energy, legend and their plates, in the draw list.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "render/picture/labels.h"
#include "tests/unit/render/picture/composition.h"

namespace wuerfel::test {
namespace {

TEST_F(Composition, HudStaysInsideThePictureAtEverySize) {
  for (const auto& [width, height] :
       {std::pair(1280, 720), std::pair(320, 180), std::pair(200, 400)}) {
    options.layers = default_layers;
    view = literal_view(snapshot, style, options, width, height);
    const DrawList list = compose_frame(snapshot, view, style, options, font);
    ASSERT_GE(list.texts.size(), 2U);
    for (const TextShape& text : list.texts) {
      const double size = static_cast<double>(text.size);
      EXPECT_GE(text.baseline.x, 0.0F) << text.text;
      EXPECT_LE(static_cast<double>(text.baseline.x) + font.width(text.text, size), width)
          << text.text;
      EXPECT_GE(static_cast<double>(text.baseline.y) - size, 0.0) << text.text;
      EXPECT_LE(text.baseline.y, static_cast<float>(height)) << text.text;
    }
  }
}

TEST_F(Composition, FittedPictureLeavesRoomForArrowsAndHud) {
  const DrawList list = compose(default_layers);
  for (const ArrowShape& arrow : arrows_of(list, style.contact)) {
    if (arrow.tail.y == arrow.tip.y) continue;  // of the legend
    EXPECT_GT(arrow.tip.y, 60.0F * 0.62F);
    EXPECT_LT(arrow.tail.y, 360.0F - 50.0F * 0.62F);
  }
}

TEST_F(Composition, LegendHasRoundNumbersAndIsAsLongAsItSays) {
  const DrawList list = compose({Layer::forces, Layer::hud});
  EXPECT_TRUE(
      std::ranges::any_of(list.texts, [](const TextShape& text) { return text.text == "20 N"; }));
  const auto arrows = arrows_of(list, style.contact);
  const double expected = 20.0 * options.force_scale.metres_per_newton * view.pixels_per_metre;
  EXPECT_TRUE(std::ranges::any_of(arrows, [&](const ArrowShape& arrow) {
    return arrow.tail.y == arrow.tip.y && std::abs(length(arrow) - expected) < 1e-3;
  }));
}

TEST_F(Composition, LinesAndTextGrowWithThePicture) {
  options.layers = default_layers;
  const auto title_size = [&](int width, int height, double scale) {
    options.scale = scale;
    view = literal_view(snapshot, style, options, width, height);
    return compose_frame(snapshot, view, style, options, font).texts.front().size;
  };
  const float normal = title_size(1280, 720, 1.0);
  EXPECT_FLOAT_EQ(title_size(2560, 1440, 1.0), 2.0F * normal);
  EXPECT_FLOAT_EQ(title_size(1280, 720, 1.5), 1.5F * normal);
}

TEST_F(Composition, LongTitleIsShortened) {
  snapshot.title = std::string(300, 'W');
  const DrawList list = compose(default_layers);
  EXPECT_TRUE(list.texts.front().text.ends_with("…"));
}

TEST_F(Composition, EveryLineOfTheHudHasAPlateOfItsOwnBehindIt) {
  snapshot.title = "A title that is longer than what is told of time";
  snapshot.planes.push_back({"wall", Vec2(-4.0, 0.0), Vec2::UnitX()});
  const DrawList list = compose({Layer::cubes, Layer::hud});
  const auto right_of_plate = [&](const TextShape& text) {
    const internal::Area area = internal::text_area(text, font);
    const auto left = static_cast<float>(area.left);
    const auto right = static_cast<float>(area.right);
    const auto top = static_cast<float>(area.top);
    const auto bottom = static_cast<float>(area.bottom);
    const auto plate = std::ranges::find_if(list.segments, [&](const SegmentShape& s) {
      return s.round == 0.0F && s.color.a > 216 && left >= s.from.x && right <= s.to.x
             && top >= s.from.y - s.half_width && bottom <= s.from.y + s.half_width;
    });
    return plate == list.segments.end() ? 0.0F : plate->to.x;
  };
  const float title = right_of_plate(list.texts[0]);
  const float time = right_of_plate(list.texts[1]);
  EXPECT_GT(time, 0.0F);
  EXPECT_EQ(right_of_plate(list.texts[2]), time);
  EXPECT_LT(time, 0.8F * title);
}

TEST_F(Composition, PlatesHaveTheColoursOfWhatTheyHide) {
  // The edge of a wall runs through the title: ground on its left, background on its right.
  view = literal_view(snapshot, style, options, 640, 360);
  const Vec2 place = view.to_world(Vec2(60.0, 20.0));
  snapshot.planes.push_back({"wall", place, Vec2::UnitX()});
  options.layers = {Layer::cubes, Layer::hud};
  const DrawList list = compose_frame(snapshot, view, style, options, font);
  const auto last_over = [&](float x, float y) {
    Color color;
    for (const SegmentShape& s : list.segments) {
      if (s.round == 0.0F && s.from.y == s.to.y && s.half_width > 5.0F && s.from.x <= x
          && x <= s.to.x && std::abs(s.from.y - y) <= s.half_width)
        color = s.color;
    }
    return color;
  };
  const float y = list.texts.front().baseline.y;
  EXPECT_EQ(last_over(40.0F, y), style.ground);
  EXPECT_EQ(last_over(80.0F, y), style.background);
}

TEST_F(Composition, TheLegendHasAPlateOverBodies) {
  // Bodies reach to the lower border, as under a camera that follows one.
  options.layers = default_layers;
  view = fixed_view(Vec2(-1.0, 1.4), 3.0, 640, 360);
  const DrawList list = compose_frame(snapshot, view, style, options, font);
  const auto hud = std::ranges::find(list.groups, "hud", &ShapeGroup::name);
  ASSERT_NE(hud, list.groups.end());
  const auto bodies = std::ranges::find(list.groups, "bodies", &ShapeGroup::name);
  EXPECT_LT(bodies->shape, hud->shape) << "the HUD is painted after all bodies";
  const TextShape& foot = list.texts.back();
  const internal::Area area = internal::text_area(foot, font);
  EXPECT_TRUE(std::ranges::any_of(list.segments, [&](const SegmentShape& s) {
    return s.round == 0.0F
           && static_cast<double>(s.from.x)<area.left&& static_cast<double>(s.to.x)> area.right
           && static_cast<double>(
                  s.from.y - s.half_width)<area.top&& static_cast<double>(s.from.y + s.half_width)>
                  area.bottom
           && s.color.a == 255;
  })) << foot.text;
}

TEST_F(Composition, TheLegendNamesNormalsAndThrust) {
  const auto says = [&](Layers layers, std::string_view what) {
    return std::ranges::any_of(compose(layers).texts,
                               [&](const TextShape& text) { return text.text == what; });
  };
  EXPECT_TRUE(says({Layer::normals, Layer::hud}, "normal"));
  EXPECT_TRUE(says({Layer::forces, Layer::hud}, "thrust"));
  EXPECT_FALSE(says({Layer::contact_forces, Layer::hud}, "thrust"));
}

TEST_F(Composition, TheLegendNamesTheForcesThatAreDrawn) {
  const auto says = [&](Layers layers, std::string_view what) {
    return std::ranges::any_of(compose(layers).texts, [&](const TextShape& text) {
      return text.text.find(what) != std::string::npos;
    });
  };
  options.legend = {LegendEntry::contact, LegendEntry::hidden};
  EXPECT_TRUE(says({Layer::weights, Layer::hud}, "N weight"));
  EXPECT_TRUE(arrows_of(compose({Layer::weights, Layer::hud}), style.contact).empty());
  EXPECT_FALSE(says({Layer::weights, Layer::forces, Layer::hud}, "N weight"));
  EXPECT_TRUE(says({Layer::forces, Layer::hud}, "below"));
  EXPECT_FALSE(says({Layer::contact_forces, Layer::hud}, "friction"));
  options.legend.insert(LegendEntry::friction);
  EXPECT_TRUE(says({Layer::contact_forces, Layer::hud}, "friction"));
}

TEST_F(Composition, LegendEntriesWithoutRoomAreCounted) {
  Layers all{Layer::hud};
  for (const Layer layer : {Layer::cubes, Layer::contact_forces, Layer::weights, Layer::normals,
                            Layer::joints, Layer::thrust, Layer::rod_forces})
    all.insert(layer);
  options.layers = all;
  const auto left_out = [&](int width) {
    view = literal_view(snapshot, style, options, width, 360);
    return compose_frame(snapshot, view, style, options, font).legend_left_out;
  };
  EXPECT_EQ(left_out(1280), 0);
  EXPECT_GT(left_out(200), 0);
}

TEST_F(Composition, TwoRowsOfALegendAreAboutAsLongAsEachOther) {
  options.legend = {LegendEntry::contact, LegendEntry::friction, LegendEntry::cut,
                    LegendEntry::several, LegendEntry::hidden,   LegendEntry::impact};
  options.layers = {Layer::contact_forces, Layer::forces, Layer::weights, Layer::hud};
  view = literal_view(snapshot, style, options, 1000, 500);
  const DrawList list = compose_frame(snapshot, view, style, options, font);
  ASSERT_EQ(list.legend_left_out, 0);
  std::map<float, double> end_of_row;
  for (const TextShape& text : list.texts) {
    if (text.baseline.y > 450.0F) {
      double& end = end_of_row[text.baseline.y];
      end = std::max(end, internal::text_area(text, font).right);
    }
  }
  ASSERT_EQ(end_of_row.size(), 2U);
  const double first = end_of_row.begin()->second;
  const double second = end_of_row.rbegin()->second;
  EXPECT_LT(std::max(first, second), 1.4 * std::min(first, second));
}

TEST_F(Composition, ALegendOfLargeTextTakesMoreRows) {
  options.layers = {Layer::contact_forces, Layer::weights, Layer::velocities, Layer::thrust,
                    Layer::joints,         Layer::normals, Layer::hud};
  const auto rows_at = [&](double scale) {
    options.scale = scale;
    view = literal_view(snapshot, style, options, 1280, 720);
    const DrawList list = compose_frame(snapshot, view, style, options, font);
    EXPECT_EQ(list.legend_left_out, 0) << scale;
    return list.legend_rows;
  };
  EXPECT_EQ(rows_at(1.0), 2);
  EXPECT_EQ(rows_at(2.0), 3);
  EXPECT_EQ(rows_at(3.0), 4);
}

TEST_F(Composition, TheLegendNamesSidesMassesAndWhiskers) {
  const auto says = [&](Layers layers, std::string_view what) {
    options.layers = layers;
    view = literal_view(snapshot, style, options, 1280, 720);
    const DrawList list = compose_frame(snapshot, view, style, options, font);
    return std::ranges::any_of(list.texts,
                               [&](const TextShape& text) { return text.text == what; });
  };
  EXPECT_TRUE(says({Layer::sides, Layer::hud}, "A ≥ 0"));
  EXPECT_FALSE(says({Layer::sides, Layer::hud}, "A < 0"));
  options.legend.insert(LegendEntry::negative);
  EXPECT_TRUE(says({Layer::sides, Layer::hud}, "A < 0"));
  EXPECT_TRUE(says({Layer::points, Layer::hud}, "mass, by area"));
  options.legend.insert(LegendEntry::range);
  EXPECT_TRUE(says({Layer::forces, Layer::whiskers, Layer::hud}, "from least to most"));
  EXPECT_FALSE(says({Layer::forces, Layer::whiskers, Layer::hud}, "and on"));
  options.legend.insert(LegendEntry::beyond);
  EXPECT_TRUE(says({Layer::forces, Layer::whiskers, Layer::hud}, "and on"));
}

TEST_F(Composition, ColorBarsPointUpWhereThereIsMore) {
  options.coloring = {ColorBy::load, 40.0};
  const auto written = [&] {
    std::string all;
    for (const TextShape& text : compose({Layer::cubes, Layer::hud}).texts)
      all += text.text + "|";
    return all;
  };
  const auto points = [&] { return compose({Layer::cubes, Layer::hud}).triangles.size(); };
  EXPECT_NE(written().find("|40 N|"), std::string::npos) << written();
  const std::size_t before = points();
  options.legend.insert(LegendEntry::above);
  EXPECT_NE(written().find("|≥ 40 N|"), std::string::npos) << written();
  EXPECT_EQ(points(), before + 1);
}

TEST_F(Composition, SmallTextOnSlidesIsDark) {
  const Style slide = make_style(Theme::transparent);
  EXPECT_EQ(slide.quiet_ink, slide.ink);
  EXPECT_LT(brightness(slide.quiet_ink), 0.2);
}

TEST_F(Composition, EnergyBelowRoundingIsNone) {
  const auto energy = [&] {
    const DrawList list = compose({Layer::hud});
    const auto text = std::ranges::find_if(
        list.texts, [](const TextShape& t) { return t.text.starts_with("E ="); });
    return text == list.texts.end() ? std::string() : text->text;
  };
  snapshot.energy_start = 0.0;
  snapshot.energy = 3.2e-12;  // J, of cubes of some 10 J
  EXPECT_EQ(energy(), "E = 0.00 J");
  snapshot.energy_start = 100.0;
  snapshot.energy = 100.0 - 1e-7;
  EXPECT_EQ(energy(), "E = 100.0 J");
  snapshot.energy = 99.0;
  EXPECT_EQ(energy(), "E = 99.0 J (−1.00 J)");
  snapshot.energy_start = 59.0982;
  snapshot.energy = 58.61;
  EXPECT_EQ(energy(), "E = 58.61 J (−0.488 J)");
}

TEST_F(Composition, TimeAndEnergyNeverMeet) {
  for (const double t : {0.0, 99.5, 100000.0, 1e9}) {
    snapshot.time = t;
    const DrawList list = compose(default_layers);
    const auto energy = std::ranges::find_if(
        list.texts, [](const TextShape& text) { return text.text.starts_with("E ="); });
    if (energy == list.texts.end()) continue;
    const internal::Area time = internal::text_area(*(energy - 1), font);
    EXPECT_LT(time.right + 5.0, energy->baseline.x) << t;
  }
}

TEST_F(Composition, PartsOfTheHudAreDroppedWhereThereIsNoRoom) {
  for (const auto& [width, height] : {std::pair(64, 64), std::pair(100, 16), std::pair(201, 77)}) {
    view = literal_view(snapshot, style, options, width, height);
    const DrawList list = compose_frame(snapshot, view, style, options, font);
    EXPECT_TRUE(list.texts.empty()) << width;
    EXPECT_GT(view.pixels_per_metre, 2.0) << "the scene is seen";
  }
}

}  // namespace
}  // namespace wuerfel::test
