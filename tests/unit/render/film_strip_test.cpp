#include "render/film_strip.h"

#include <gtest/gtest.h>

#include "render/error.h"

namespace wuerfel {
namespace {

TEST(FilmStrip, GridIsParsed) {
  EXPECT_EQ(parse_strip("4x2").columns, 4);
  EXPECT_EQ(parse_strip("4x2").rows, 2);
  for (const char* text : {"", "4", "x2", "4x", "0x2", "4x-1", "4x2x1", "4 x 2"}) {
    EXPECT_THROW(parse_strip(text), RenderError) << text;
  }
}

TEST(FilmStrip, TimesAreEvenAndIncludeBothEnds) {
  EXPECT_EQ(strip_times(5, 2.0), (std::vector<double>{0.0, 0.5, 1.0, 1.5, 2.0}));
  EXPECT_EQ(strip_times(1, 2.0), (std::vector<double>{2.0}));
}

TEST(FilmStrip, FramesLieInTheirCellsAndDoNotTouch) {
  const StripLayout layout = strip_layout({3, 2}, 640, 360, 1.0);
  std::vector<Image> frames;
  std::vector<std::string> captions;
  for (int i = 0; i < 6; ++i) {
    frames.emplace_back(layout.cell_width, layout.cell_height,
                        rgb(0x100000U * static_cast<unsigned>(i + 1)));
    captions.push_back("t = " + std::to_string(i) + " s");
  }
  Font font;
  const Style style = make_style(Theme::light);
  const Image sheet = film_strip(frames, captions, layout, style, font);
  EXPECT_EQ(sheet.width(), 640);
  for (int i = 0; i < 6; ++i) {
    const int x = layout.gap + i % 3 * (layout.cell_width + layout.gap);
    const int y = layout.gap + i / 3 * (layout.cell_height + layout.caption_height + layout.gap);
    EXPECT_EQ(sheet.at(x, y), frames[static_cast<std::size_t>(i)].at(0, 0)) << i;
    EXPECT_EQ(sheet.at(x + layout.cell_width - 1, y + layout.cell_height - 1),
              frames[static_cast<std::size_t>(i)].at(0, 0));
    EXPECT_EQ(sheet.at(x - 2, y), style.background);
    bool ink = false;
    for (int row = y + layout.cell_height + 2; row < y + layout.cell_height + layout.caption_height;
         ++row) {
      for (int column = x; column < x + 40; ++column)
        ink = ink || brightness(sheet.at(column, row)) < 0.6;
    }
    EXPECT_TRUE(ink) << "caption " << i;
  }
}

TEST(FilmStrip, ThatDoesNotFitIsAnError) {
  EXPECT_THROW(strip_layout({40, 2}, 640, 360, 1.0), RenderError);
}

}  // namespace
}  // namespace wuerfel
