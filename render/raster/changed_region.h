/// Which part of a picture has to be drawn again when its draw list changes.
#pragma once

#include <cstddef>

#include "render/picture/draw_list.h"
#include "render/raster/row_set.h"

namespace wuerfel::internal {

/// Whole pixels from `left`, `top` to before `right`, `bottom`.
struct Region {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
  friend bool operator==(const Region&, const Region&) = default;

  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

Region whole_picture(const DrawList& list);

/// A rectangle outside of which the shapes of `before` and `after`, lists of one size and
/// background, have the same pixels. Shapes at the same place in the painting order that are equal
/// don't count. Never empty. Texts are not looked at.
Region changed_region(const DrawList& before, const DrawList& after);

/// Rows outside of which the texts of `before` and `after` have the same pixels.
RowSet changed_text_rows(const DrawList& before, const DrawList& after);

/// Rows that hold all pixels of a text, in a picture of this height.
RowRange rows_of(const TextShape& text, int height);

}  // namespace wuerfel::internal
