#include "render/raster/extent.h"

#include <algorithm>
#include <cmath>

namespace wuerfel::internal {
namespace {

Extent around(Pixel a, Pixel b, float margin) {
  return {std::min(a.x, b.x) - margin, std::min(a.y, b.y) - margin, std::max(a.x, b.x) + margin,
          std::max(a.y, b.y) + margin};
}

// The quads of assets/shaders reach one pixel farther than their shapes.
constexpr float fringe = 2.0F;

}  // namespace

Extent extent(const BoxShape& box) {
  const float width = box.half_size.x + fringe;
  const float height = box.half_size.y + fringe;
  const float x = std::abs(box.axis.x) * width + std::abs(box.axis.y) * height;
  const float y = std::abs(box.axis.y) * width + std::abs(box.axis.x) * height;
  return {box.center.x - x, box.center.y - y, box.center.x + x, box.center.y + y};
}

Extent extent(const SegmentShape& segment) {
  return around(segment.from, segment.to, 2.0F * (segment.half_width + fringe));
}

Extent extent(const ArrowShape& arrow) {
  // A halo's corners run ahead by up to 3.5 times its width; the head's by its own half width.
  const float margin = std::max(arrow.half_width, arrow.head_half_width) + arrow.head_length
                       + 3.5F * arrow.grow + fringe;
  return around(arrow.tail, arrow.tip, 1.5F * margin);
}

Extent extent(const DiscShape& disc) {
  return around(disc.center, disc.center, disc.radius + fringe);
}

Extent extent(const TriangleShape& triangle) {
  const Extent ab = around(triangle.a, triangle.b, fringe);
  const Extent bc = around(triangle.b, triangle.c, fringe);
  return {std::min(ab.left, bc.left), std::min(ab.top, bc.top), std::max(ab.right, bc.right),
          std::max(ab.bottom, bc.bottom)};
}

}  // namespace wuerfel::internal
