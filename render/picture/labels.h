/// Labels: finds free places for texts.
#pragma once

#include <span>
#include <vector>

#include "render/picture/draw_list.h"
#include "render/picture/font.h"

namespace wuerfel::internal {

/// A rectangle in pixels.
struct Area {
  double left = 0.0;
  double top = 0.0;
  double right = 0.0;
  double bottom = 0.0;
};

/// What a text covers.
Area text_area(const TextShape& text, Font& font);
/// What texts cover together.
Area common_area(std::span<const TextShape> texts, Font& font);

class Labels {
 public:
  /// Labels of a picture of this size. Throws nothing.
  Labels(int width, int height) : picture_{0.0, 0.0, 1.0 * width, 1.0 * height} {}

  /// A stroke, or an area, that no label may lie on.
  void keep_off(Pixel from, Pixel to, double half_width);
  void keep_off(const Area& area) { areas_.push_back(area); }

  /// Puts the text at the first of the baselines where it is free, and keeps that place; false where
  /// there is none.
  bool place(TextShape text, std::span<const Pixel> baselines, Font& font, DrawList& list);
  /// The same of texts that belong together; their own baselines count from the one they get.
  bool place(std::vector<TextShape> texts,
             std::span<const Pixel> baselines,
             Font& font,
             DrawList& list);

 private:
  struct Stroke {
    Pixel from;
    Pixel to;
    double half_width = 0.0;
  };
  [[nodiscard]] bool is_free(const Area& area) const;

  Area picture_;
  std::vector<Stroke> strokes_;
  std::vector<Area> areas_;
};

}  // namespace wuerfel::internal
