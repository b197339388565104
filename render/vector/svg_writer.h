/// SvgWriter: a draw list as SVG as one would write it by hand: text as text, a group for each layer,
/// bodies with their names.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "render/picture/draw_list.h"
#include "render/vector/vector_figure.h"

namespace wuerfel::internal {

class SvgWriter {
 public:
  /// The head of a document of this size in pixels.
  SvgWriter(int width, int height, const FigureTexts& texts);

  /// A picture with its upper left corner at (x, y), cut off at its borders. Ids begin with `prefix`.
  void add(const DrawList& list, int x, int y, const std::string& prefix);
  /// The whole document.
  std::string finish();

 private:
  void add_shape(const DrawList& list, const ShapeRun& run, std::size_t i);
  void add(const BoxShape& box, int body);
  void add(const ArrowShape& arrow);
  void add(const DiscShape& disc);
  void add(const TriangleShape& triangle);
  void add(const TextShape& text);
  /// Strokes that follow one another in one style are one path; returns the first behind them.
  std::size_t add_strokes(const DrawList& list, std::size_t first, std::size_t end);
  void open_group(std::string_view name);
  void close_group();

  const FigureTexts* texts_;
  std::string svg_;
  std::string prefix_;
  int clips_ = 0;
  int gradients_ = 0;
  bool in_group_ = false;
};

/// The texts that `encode_vector_figure` put into an SVG document. Throws RenderError where it has
/// none.
std::vector<PngText> origin_of_svg(std::string_view svg);

}  // namespace wuerfel::internal
