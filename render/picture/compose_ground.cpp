// Grid, half-planes and trails: what lies behind the bodies.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "render/picture/frame_parts.h"

namespace wuerfel::internal {
namespace {

constexpr double grid_spacing = 110.0;  ///< px at most
constexpr double hatch_spacing = 11.0;
constexpr double hatch_depth = 8.0;

/// The part of a line, measured along its direction from its point.
struct Span {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();

  /// Keeps where start + slope * t >= 0.
  void keep(double start, double slope) {
    if (slope > 0.0) from = std::max(from, -start / slope);
    if (slope < 0.0) to = std::min(to, -start / slope);
    if (slope == 0.0 && start < 0.0) to = from = 0.0;
  }
  bool empty() const { return !(from < to); }
};

/// The whole numbers from `low` to `high`. None where these are so large that numbers one apart can
/// no longer be told apart (2^53): a view so far out has no grid.
std::vector<double> whole_numbers(double low, double high) {
  constexpr double largest = 9007199254740992.0;
  std::vector<double> numbers;
  if (!(std::abs(low) < largest && std::abs(high) < largest)) return numbers;
  for (double k = std::ceil(low); k <= high; k += 1.0)
    numbers.push_back(k);
  return numbers;
}

/// The visible part of a plane's surface, in metres along `along` from its point, with `margin` px
/// around the picture; what lies inside another half-plane is left out.
Span visible_surface(const FrameParts& parts,
                     const SnapshotPlane& plane,
                     const Vec2& along,
                     double margin) {
  Span span;
  const double reach = margin / parts.view.pixels_per_metre;
  const Vec2 low = parts.view.to_world(Vec2(0.0, parts.view.height));
  const Vec2 high = parts.view.to_world(Vec2(parts.view.width, 0.0));
  span.keep(plane.point.x() - low.x() + reach, along.x());
  span.keep(high.x() + reach - plane.point.x(), -along.x());
  span.keep(plane.point.y() - low.y() + reach, along.y());
  span.keep(high.y() + reach - plane.point.y(), -along.y());
  for (const SnapshotPlane& other : parts.snapshot.planes) {
    if (&other == &plane) continue;
    span.keep((plane.point - other.point).dot(other.normal), along.dot(other.normal));
  }
  return span;
}

void add_solid(const FrameParts& parts, const SnapshotPlane& plane, const Vec2& along) {
  const Vec2 middle = parts.view.to_world(Vec2(0.5 * parts.view.width, 0.5 * parts.view.height));
  const double reach = 2.0 * (parts.view.width + parts.view.height) / parts.view.pixels_per_metre;
  const double height = (middle - plane.point).dot(plane.normal);
  if (height > reach) return;
  BoxShape solid;
  const double depth = std::max(reach, -height + reach);
  solid.center = parts.pixel(middle - (height + 0.5 * depth) * plane.normal);
  solid.axis = {static_cast<float>(along.x()), static_cast<float>(-along.y())};
  solid.half_size = {static_cast<float>(reach * parts.view.pixels_per_metre),
                     static_cast<float>(0.5 * depth * parts.view.pixels_per_metre)};
  solid.fill = parts.style.ground;
  parts.list.add(solid);
}

/// Short slanted strokes below the surface, at places fixed in the world so that they don't swim.
void add_hatch(const FrameParts& parts, const SnapshotPlane& plane, const Vec2& along, Span span) {
  const double per_pixel = 1.0 / parts.view.pixels_per_metre;
  const double step = hatch_spacing * parts.unit * per_pixel;
  const double depth = hatch_depth * parts.unit * per_pixel;
  const Vec2 stroke = -depth * (plane.normal + along);
  SegmentShape segment;
  segment.half_width = static_cast<float>(0.55 * parts.unit);
  segment.color = parts.style.hatch;
  const double first = std::ceil((span.from + depth) / step) * step;
  for (const double i : whole_numbers(0.0, (span.to - first) / step)) {
    const Vec2 start = plane.point + (first + i * step) * along;
    segment.from = parts.pixel(start);
    segment.to = parts.pixel(start + stroke);
    parts.list.add(segment);
  }
}

}  // namespace

void add_grid(const FrameParts& parts) {
  const double step = round_down_125(grid_spacing * parts.unit / parts.view.pixels_per_metre);
  const Vec2 low = parts.view.to_world(Vec2(0.0, parts.view.height));
  const Vec2 high = parts.view.to_world(Vec2(parts.view.width, 0.0));
  const auto width = static_cast<float>(parts.view.width);
  const auto height = static_cast<float>(parts.view.height);
  SegmentShape line;
  line.round = 0.0F;
  line.half_width = static_cast<float>(0.6 * parts.unit);
  for (const double k : whole_numbers(low.x() / step, high.x() / step)) {
    const float x = parts.pixel(Vec2(k * step, 0.0)).x;
    line.from = {x, 0.0F};
    line.to = {x, height};
    line.color = k == 0.0 ? parts.style.grid_axis : parts.style.grid;
    parts.list.add(line);
  }
  for (const double k : whole_numbers(low.y() / step, high.y() / step)) {
    const float y = parts.pixel(Vec2(0.0, k * step)).y;
    line.from = {0.0F, y};
    line.to = {width, y};
    line.color = k == 0.0 ? parts.style.grid_axis : parts.style.grid;
    parts.list.add(line);
  }
}

void add_ground(const FrameParts& parts) {
  const auto along_of = [](const SnapshotPlane& plane) { return Vec2(-perp(plane.normal)); };
  for (const SnapshotPlane& plane : parts.snapshot.planes)
    add_solid(parts, plane, along_of(plane));
  for (const SnapshotPlane& plane : parts.snapshot.planes) {
    const Vec2 along = along_of(plane);
    const Span span = visible_surface(parts, plane, along, 40.0 * parts.unit);
    if (!span.empty()) add_hatch(parts, plane, along, span);
  }
  for (const SnapshotPlane& plane : parts.snapshot.planes) {
    const Vec2 along = along_of(plane);
    const Span span = visible_surface(parts, plane, along, 40.0 * parts.unit);
    if (span.empty()) continue;
    SegmentShape line;
    const double half_width = 0.5 * parts.style.ground_line_width * parts.unit;
    line.half_width = static_cast<float>(half_width);
    const Vec2 sunk = plane.point - half_width / parts.view.pixels_per_metre * plane.normal;
    line.from = parts.pixel(sunk + span.from * along);
    line.to = parts.pixel(sunk + span.to * along);
    line.color = parts.style.ground_line;
    parts.list.add(line);
    parts.labels.keep_off(line.from, line.to, half_width);
  }
}

void add_trails(const FrameParts& parts) {
  for (const SnapshotTrail& trail : parts.snapshot.trails) {
    SnapshotBox owner;
    owner.color_index = trail.color_index;
    owner.color = trail.color;
    const Color color = mix(body_color(parts.style, owner), parts.style.ink, 0.3);
    SegmentShape segment;
    segment.half_width = parts.weight(1.7);
    segment.round = 0.0F;
    for (std::size_t i = 1; i < trail.path.size(); ++i) {
      const double age = static_cast<double>(i) / static_cast<double>(trail.path.size());
      segment.from = parts.pixel(trail.path[i - 1]);
      segment.to = parts.pixel(trail.path[i]);
      segment.color = with_alpha(color, 0.2 + 0.8 * age);
      parts.list.add(segment);
    }
  }
}

}  // namespace wuerfel::internal
