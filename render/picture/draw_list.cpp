#include "render/picture/draw_list.h"

namespace wuerfel {
namespace {

/// Appends to the run at the end of the painting order, or starts a new one.
template <typename Shape>
void append(const Shape& shape,
            ShapeKind kind,
            std::vector<Shape>& shapes,
            std::vector<ShapeRun>& runs) {
  if (runs.empty() || runs.back().kind != kind) runs.push_back({kind, shapes.size(), 0});
  shapes.push_back(shape);
  ++runs.back().count;
}

}  // namespace

void DrawList::begin_group(std::string_view name) {
  const std::size_t shape =
      boxes.size() + segments.size() + arrows.size() + discs.size() + triangles.size();
  // One that stayed empty is none.
  if (!groups.empty() && groups.back().shape == shape) groups.pop_back();
  groups.push_back({name, shape});
}

void DrawList::add(const BoxShape& shape) { append(shape, ShapeKind::box, boxes, runs); }
void DrawList::add(const SegmentShape& shape) { append(shape, ShapeKind::segment, segments, runs); }
void DrawList::add(const ArrowShape& shape) { append(shape, ShapeKind::arrow, arrows, runs); }
void DrawList::add(const DiscShape& shape) { append(shape, ShapeKind::disc, discs, runs); }
void DrawList::add(const TriangleShape& shape) {
  append(shape, ShapeKind::triangle, triangles, runs);
}

}  // namespace wuerfel
