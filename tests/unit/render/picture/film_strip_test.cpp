#include "render/picture/film_strip.h"

#include <gtest/gtest.h>

#include "render/error.h"
#include "render/raster/renderer.h"

namespace wuerfel::test {
namespace {

TEST(FilmStrip, TimesAreEvenAndIncludeBothEnds) {
  EXPECT_EQ(strip_times(5, 2.0), (std::vector<double>{0.0, 0.5, 1.0, 1.5, 2.0}));
  EXPECT_EQ(strip_times(1, 2.0), (std::vector<double>{2.0}));
}

TEST(FilmStrip, CellsDoNotTouchAndHaveTheirCaptionsBelow) {
  const StripLayout layout = strip_layout({3, 2}, 640, 360, 1.0);
  const std::vector<std::string> captions{"t = 0 s", "t = 1 s", "t = 2 s",
                                          "t = 3 s", "t = 4 s", "t = 5 s"};
  const Style style = make_style(Theme::light);
  Renderer renderer;
  Image page;
  renderer.draw(strip_page(captions, layout, style), page);
  EXPECT_EQ(page.width(), 640);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto [x, y] = cell_place(layout, i);
    ASSERT_LE(x + layout.cell_width, 640);
    ASSERT_LE(y + layout.cell_height + layout.caption_height, 360);
    // The border lies outside the frame.
    EXPECT_EQ(page.at(x, y), style.background) << i;
    EXPECT_EQ(page.at(x + layout.cell_width - 1, y + layout.cell_height - 1), style.background);
    EXPECT_EQ(page.at(x - 1, y + 9), style.grid_axis) << i;
    EXPECT_EQ(page.at(x + layout.cell_width, y + 9), style.grid_axis) << i;
    EXPECT_EQ(page.at(x - 3, y), style.background);
    bool ink = false;
    for (int row = y + layout.cell_height + 2; row < y + layout.cell_height + layout.caption_height;
         ++row) {
      for (int column = x; column < x + 40; ++column)
        ink = ink || brightness(page.at(column, row)) < 0.6;
    }
    EXPECT_TRUE(ink) << "caption " << i;
  }
}

TEST(FilmStrip, ThatDoesNotFitIsAnError) {
  EXPECT_THROW(strip_layout({40, 2}, 640, 360, 1.0), RenderError);
}

TEST(FilmStrip, NumbersBeyondReasonAreErrorsAndNoOverflows) {
  EXPECT_THROW(strip_layout({2147483647, 2}, 1280, 720, 1.0), RenderError);
  EXPECT_THROW(strip_layout({65536, 65536}, 1280, 720, 1.0), RenderError);
  EXPECT_THROW(strip_layout({2, 2}, 1280, 720, 1e9), RenderError);
}

}  // namespace
}  // namespace wuerfel::test
