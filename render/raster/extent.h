/// Extent: which pixels a shape may change.
#pragma once

#include "render/picture/draw_list.h"

namespace wuerfel::internal {

/// In pixels, wide enough for every pixel that a shape may change.
struct Extent {
  float left = 0.0F;
  float top = 0.0F;
  float right = 0.0F;
  float bottom = 0.0F;
};

Extent extent(const BoxShape& box);
Extent extent(const SegmentShape& segment);
Extent extent(const ArrowShape& arrow);
Extent extent(const DiscShape& disc);
Extent extent(const TriangleShape& triangle);

}  // namespace wuerfel::internal
