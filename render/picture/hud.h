/// What the HUD is made of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/picture/frame_parts.h"

namespace wuerfel::internal {

constexpr double hud_margin = 20.0;  ///< px of a 1280x720 picture

/// A plate in the colours of background and ground, on which no label comes to lie.
void add_plate(const FrameParts& parts, const Area& area);

/// A rectangle without an outline.
void add_bar(const FrameParts& parts, const Area& area, Color color);

/// Lines of text on a plate.
class HudText {
 public:
  explicit HudText(const FrameParts& parts) : parts_(parts) {}
  void add(std::string text, double x, double y, double size, Color color);
  void paint();

 private:
  const FrameParts& parts_;
  std::vector<TextShape> texts_;
};

/// What an arrow in the legend says: so many metres for one unit.
struct ArrowScale {
  double metres_per_unit = 0.0;
  std::string_view unit;
  std::string_view meaning;
};

struct ArrowMarks {
  bool hollow = false;
  bool cut = false;
};

/// Rows of symbols with labels, from left to right, over a share of the picture's width; what has no room
/// then is left out and counted. It is gone through again and again: measured, so that the plate is as large as the
/// rows and all are about as long as each other, and painted.
class LegendRow {
 public:
  enum class Pass { measuring, painting };
  LegendRow(const FrameParts& parts, Pass pass, double share, int rows = 1);
  [[nodiscard]] int rows() const { return row_ + 1; }
  [[nodiscard]] int left_out() const { return left_out_; }

  void scale_bar();
  /// An arrow of a round number of units.
  void arrow(const ArrowScale& scale, Color color, ArrowForm form);
  /// An arrow that stands for its kind.
  void sample(std::string_view meaning, Color color, ArrowMarks marks);
  void normal(std::string_view meaning);
  void dot(std::string_view meaning, Color color);
  void ring(std::string_view meaning, Color color);
  /// A thick stroke: rods in tension or compression.
  void swatch(std::string_view meaning, Color color);
  void dashes(std::string_view meaning, Color color);
  /// A side with its corner.
  void triangle(std::string_view meaning, bool negative);
  void comb(std::string_view meaning, Color color);
  void whisker(std::string_view meaning, bool goes_on);
  /// A dashed square.
  void moved_box(std::string_view meaning, Color color);
  /// A square in a thick outline.
  void failing_box(std::string_view meaning, Color color);
  void paint_plate() const;

 private:
  /// Calls `draw` with the left and right ends of a symbol so long, where it fits.
  template <typename Draw>
  void entry(double symbol, std::string_view label, const Draw& draw);
  [[nodiscard]] bool has_room_below() const;
  [[nodiscard]] float middle() const;
  void stroke(Pixel from, Pixel to, double width, Color color);

  const FrameParts& parts_;
  Pass pass_;
  double size_;
  double x_;
  double baseline_;  ///< of the row at hand
  double right_;     ///< where the longest row ends
  double end_;       ///< that no row may exceed
  int row_ = 0;
  int left_out_ = 0;  ///< entries
};

/// The scale of the bodies' colours where they are numbers.
void add_color_bar(const FrameParts& parts);

}  // namespace wuerfel::internal
