// Vector figures, rasterised by other programs (librsvg, poppler) and laid beside what OSMesa
// draws.
#include "render/vector/vector_figure.h"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <unistd.h>

#include <gtest/gtest.h>

#include "render/error.h"
#include "render/files/output_file.h"
#include "render/files/png.h"
#include "render/picture/compose_frame.h"
#include "render/raster/compare.h"
#include "render/raster/renderer.h"
#include "tests/support/image_scenes.h"
#include "tests/support/own_folder.h"

namespace wuerfel::test {
namespace {

class VectorFigure : public OwnFolder {
 protected:
  DrawList compose(Theme theme, Layers layers) {
    const bool sides = layers.has(Layer::sides);
    const Snapshot snapshot = sides ? two_cubes_snapshot() : pyramid_snapshot();
    const Style style = make_style(theme);
    const FrameOptions options = literal_options(layers);
    return compose_frame(snapshot, literal_view(snapshot, style, options, 640, 360), style, options,
                         font);
  }

  void write(const std::string& name, const DrawList& list) {
    const auto bytes = encode_vector_figure(list, *vector_format(name), font);
    OutputFile file(path(name));
    file.write(bytes);
    file.commit();
  }

  std::string encoded(VectorFormat format) {
    const auto bytes = encode_vector_figure(compose(Theme::light, default_layers), format, font);
    return {bytes.begin(), bytes.end()};
  }

  /// Share of pixels that differ from OSMesa's by more than antialiasing explains.
  double unlike_osmesa(const DrawList& list, const Image& rasterised) {
    Renderer renderer;
    Image image;
    renderer.draw(list, image);
    constexpr int edge = 100;
    int unlike = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const Color a = image.at(x, y);
        const Color b = rasterised.at(x, y);
        if (std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}) > edge)
          ++unlike;
      }
    }
    return static_cast<double>(unlike) / (640.0 * 360.0);
  }

  std::filesystem::path folder;
  Font font;
};

/// Observed: none in SVG, 0.07 % in PDF, where poppler draws thin lines a little thicker.
constexpr double svg_share = 0.0001;
constexpr double antialiasing_share = 0.001;

TEST_F(VectorFigure, SvgLooksLikeOsmesasPicture) {
  for (const Layers layers :
       {Layers{Layer::cubes, Layer::rods, Layer::points, Layer::forces},
        Layers{Layer::cubes, Layer::sides}, Layers{Layer::cubes, Layer::rod_forces}}) {
    const DrawList list = compose(Theme::light, layers);
    write("a.svg", list);
    ASSERT_EQ(
        std::system(("rsvg-convert '" + path("a.svg") + "' -o '" + path("a.png") + "'").c_str()),
        0);
    EXPECT_LT(unlike_osmesa(list, read_png(path("a.png")).image), svg_share) << to_string(layers);
  }
}

TEST_F(VectorFigure, MissingArrowWouldBeSeen) {
  DrawList list = compose(Theme::light, {Layer::cubes, Layer::forces});
  write("a.svg", list);
  ASSERT_EQ(
      std::system(("rsvg-convert '" + path("a.svg") + "' -o '" + path("a.png") + "'").c_str()), 0);
  list.runs.back().count -= 3;
  EXPECT_GT(unlike_osmesa(list, read_png(path("a.png")).image), svg_share);
}

TEST_F(VectorFigure, PdfLooksLikeOsmesasPicture) {
  const DrawList list =
      compose(Theme::light, {Layer::cubes, Layer::rods, Layer::forces, Layer::contacts});
  write("a.pdf", list);
  ASSERT_EQ(
      std::system(
          ("pdftoppm -r 96 -singlefile -png '" + path("a.pdf") + "' '" + path("a") + "'").c_str()),
      0);
  EXPECT_LT(unlike_osmesa(list, read_png(path("a.png")).image), antialiasing_share);
}

TEST_F(VectorFigure, SameListGivesTheSameBytes) {
  for (const VectorFormat format : {VectorFormat::svg, VectorFormat::pdf})
    EXPECT_EQ(encoded(format), encoded(format));
}

TEST_F(VectorFigure, CarriesNoDate) {
  EXPECT_EQ(encoded(VectorFormat::pdf).find("CreationDate"), std::string::npos);
}

TEST_F(VectorFigure, PdfKeepsTextAsText) {
  write("a.pdf", compose(Theme::light, default_layers));
  ASSERT_EQ(std::system(
                ("pdftotext '" + path("a.pdf") + "' - | grep -q 'Drei Würfel auf dreien'").c_str()),
            0);
}

TEST_F(VectorFigure, TransparentThemeHasNoBackground) {
  write("a.svg", compose(Theme::transparent, {Layer::forces}));
  ASSERT_EQ(
      std::system(("rsvg-convert '" + path("a.svg") + "' -o '" + path("a.png") + "'").c_str()), 0);
  EXPECT_EQ(read_png(path("a.png")).image.at(2, 2).a, 0);
}

TEST_F(VectorFigure, SvgIsAsOneWouldWriteIt) {
  const FigureTexts texts{"Ein <Titel> & mehr",
                          "t = 1.25 s",
                          {{"Options", "--size 640x360"}, {"Scene", "{\"a\": \"<&>\"}\n"}},
                          {"a", "b", "c", "d e"},
                          84.0};
  const auto bytes = encode_vector_figure(
      compose(Theme::light, {Layer::cubes, Layer::forces, Layer::trails, Layer::names, Layer::hud}),
      VectorFormat::svg, font, {}, texts);
  const std::string svg(bytes.begin(), bytes.end());
  const auto has = [&svg](std::string_view text) { return svg.find(text) != std::string::npos; };
  EXPECT_TRUE(has("width=\"84mm\" height=\"47.25mm\""));
  EXPECT_TRUE(has("<title>Ein &lt;Titel&gt; &amp; mehr</title>"));
  EXPECT_TRUE(has(">Drei Würfel auf dreien</text>")) << "text is text";
  EXPECT_TRUE(has("<g class=\"bodies\">"));
  EXPECT_TRUE(has("<rect class=\"body\" id=\"body-d_e\""));
  EXPECT_TRUE(has("<g class=\"arrows\">"));
  std::size_t trails = 0;
  for (std::size_t at = 0; (at = svg.find("<linearGradient", at)) != std::string::npos; ++at)
    ++trails;
  EXPECT_EQ(trails, 2U) << "each trail is one path";
  EXPECT_EQ(read_origin(svg), texts.origin);
  OutputFile file(path("b.svg"));
  file.write(bytes);
  file.commit();
  EXPECT_EQ(std::system(("xmllint --noout '" + path("b.svg") + "' 2>/dev/null || rsvg-convert '"
                         + path("b.svg") + "' -o /dev/null")
                            .c_str()),
            0);
}

TEST_F(VectorFigure, PdfHasATitleItsOriginAndTheWidthAskedFor) {
  FigureTexts texts;
  texts.title = "Drei Würfel";
  texts.origin = {{"Options", "--size 640x360"}};
  texts.width_mm = 84.0;
  const auto bytes = encode_vector_figure(compose(Theme::light, default_layers), VectorFormat::pdf,
                                          font, {}, texts);
  OutputFile file(path("a.pdf"));
  file.write(bytes);
  file.commit();
  EXPECT_EQ(
      std::system(("pdfinfo '" + path("a.pdf") + "' | grep -q '^Title: *Drei Würfel$'").c_str()),
      0);
  EXPECT_EQ(
      std::system(
          ("pdfinfo '" + path("a.pdf") + "' | grep -q '^Keywords: .*--size 640x360'").c_str()),
      0);
  EXPECT_EQ(std::system(("pdfinfo '" + path("a.pdf") + "' | grep -q '^Page size: *238.1'").c_str()),
            0);
}

TEST_F(VectorFigure, DamagedOriginIsAnError) {
  EXPECT_TRUE(read_origin("<svg></svg>").empty());
  EXPECT_THROW(read_origin("<text xmlns=\"urn:wuerfel:origin\" key=\"Scene\">cut off"),
               RenderError);
}

TEST_F(VectorFigure, InsetsAreCutOffAtTheirBorders) {
  DrawList page;
  page.width = 100;
  page.height = 60;
  page.background = rgb(0xFFFFFF);
  PlacedList inset{{}, 40, 20};
  inset.list.width = 30;
  inset.list.height = 10;
  inset.list.background = rgb(0x0000FF);
  inset.list.add(SegmentShape{{-50.0F, 5.0F}, {50.0F, 5.0F}, 1.0F, 0.0F, rgb(0xFF0000)});
  OutputFile file(path("a.svg"));
  file.write(encode_vector_figure(page, VectorFormat::svg, font, {&inset, 1}));
  file.commit();
  ASSERT_EQ(
      std::system(("rsvg-convert '" + path("a.svg") + "' -o '" + path("a.png") + "'").c_str()), 0);
  const Image image = read_png(path("a.png")).image;
  EXPECT_EQ(image.at(41, 21), rgb(0x0000FF));
  EXPECT_EQ(image.at(41, 25), rgb(0xFF0000));
  EXPECT_EQ(image.at(38, 25), rgb(0xFFFFFF));
  EXPECT_EQ(image.at(71, 25), rgb(0xFFFFFF));
}

TEST_F(VectorFigure, FormatIsToldBySuffix) {
  EXPECT_EQ(vector_format("a.svg"), VectorFormat::svg);
  EXPECT_EQ(vector_format("a.pdf"), VectorFormat::pdf);
  EXPECT_EQ(vector_format("a.png"), std::nullopt);
}

}  // namespace
}  // namespace wuerfel::test
