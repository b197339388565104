#include "core/scene/overlap.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "core/geometry/box.h"
#include "core/geometry/broad_phase.h"

namespace wuerfel {
namespace {

struct SweptBox {
  Box box;
  BoundingBox bounds;
  BodyRef body;
};

SweptBox swept_box(const Vec2& position, double angle, const Vec2& size, const BodyRef& body) {
  SweptBox swept;
  swept.box = make_box(position, angle, size);
  swept.bounds = {swept.box.corner(0), swept.box.corner(0)};
  for (int k = 1; k < 4; ++k) {
    swept.bounds.low = swept.bounds.low.cwiseMin(swept.box.corner(k));
    swept.bounds.high = swept.bounds.high.cwiseMax(swept.box.corner(k));
  }
  swept.body = body;
  return swept;
}

std::vector<SweptBox> swept_boxes(const Scene& scene) {
  std::vector<SweptBox> boxes;
  boxes.reserve(scene.fixed.size() + scene.cubes.size());
  int index = 0;
  for (const SceneFixed& fixed : scene.fixed) {
    boxes.push_back(swept_box(fixed.position, fixed.angle, fixed.size, {BodyKind::fixed, index++}));
  }
  index = 0;
  for (const SceneCube& cube : scene.cubes) {
    boxes.push_back(swept_box(cube.position, cube.angle, cube.size, {BodyKind::cube, index++}));
  }
  return boxes;
}

/// Sorts along the axis on which the boxes spread more and returns it.
int sort_for_sweep(std::vector<SweptBox>& boxes) {
  BoundingBox all = boxes.front().bounds;
  for (const SweptBox& swept : boxes) {
    all.low = all.low.cwiseMin(swept.bounds.low);
    all.high = all.high.cwiseMax(swept.bounds.high);
  }
  const Vec2 spread = all.high - all.low;
  const int axis = spread.x() >= spread.y() ? 0 : 1;
  std::sort(boxes.begin(), boxes.end(), [axis](const SweptBox& a, const SweptBox& b) {
    const double low_a = a.bounds.low[axis];
    const double low_b = b.bounds.low[axis];
    return low_a < low_b || (low_a == low_b && a.body < b.body);
  });
  return axis;
}

std::optional<Overlap> overlap_of(const SweptBox& a, const SweptBox& b) {
  if (a.body.kind != BodyKind::cube && b.body.kind != BodyKind::cube) return std::nullopt;
  if (!a.bounds.overlaps(b.bounds)) return std::nullopt;
  const double gap = separation(a.box, b.box);
  const double smaller_side = std::min(a.box.smaller_side(), b.box.smaller_side());
  if (gap >= -touching_tolerance * smaller_side) return std::nullopt;
  return Overlap{std::min(a.body, b.body), std::max(a.body, b.body), -gap};
}

std::optional<Overlap> sweep(std::vector<SweptBox>& boxes) {
  const int axis = sort_for_sweep(boxes);
  std::vector<const SweptBox*> open;  // boxes that reach to the sweep line
  for (const SweptBox& swept : boxes) {
    std::erase_if(open, [&](const SweptBox* other) {
      return other->bounds.high[axis] < swept.bounds.low[axis];
    });
    for (const SweptBox* other : open) {
      if (auto overlap = overlap_of(*other, swept)) return overlap;
    }
    open.push_back(&swept);
  }
  return std::nullopt;
}

std::optional<Overlap> overlap_with_plane(const Scene& scene, const std::vector<SweptBox>& boxes) {
  for (const SweptBox& swept : boxes) {
    if (swept.body.kind != BodyKind::cube) continue;
    int index = 0;
    for (const ScenePlane& plane : scene.planes) {
      const double gap = plane_separation(plane.point, plane.normal, swept.box);
      if (gap < -touching_tolerance * swept.box.smaller_side()) {
        return Overlap{{BodyKind::plane, index}, swept.body, -gap};
      }
      ++index;
    }
  }
  return std::nullopt;
}

/// Overlap of so many last digits of a coordinate is what rounding may make of touching.
constexpr double few_digits = 16.0;

/// The largest coordinate of a body, m.
double farthest(const Scene& scene, const BodyRef& body) {
  const auto i = static_cast<std::size_t>(body.index);
  const Vec2& place = body.kind == BodyKind::plane   ? scene.planes[i].point
                      : body.kind == BodyKind::fixed ? scene.fixed[i].position
                                                     : scene.cubes[i].position;
  return place.cwiseAbs().maxCoeff();
}

}  // namespace

const std::string& body_name(const Scene& scene, const BodyRef& body) {
  const auto i = static_cast<std::size_t>(body.index);
  if (body.kind == BodyKind::plane) return scene.planes[i].name;
  if (body.kind == BodyKind::fixed) return scene.fixed[i].name;
  return scene.cubes[i].name;
}

std::optional<Overlap> find_overlap(const Scene& scene) {
  std::vector<SweptBox> boxes = swept_boxes(scene);
  if (boxes.empty()) return std::nullopt;
  if (auto overlap = sweep(boxes)) return overlap;
  return overlap_with_plane(scene, boxes);
}

std::string overlap_message(const Scene& scene, const Overlap& overlap) {
  std::string text =
      fmt::format("\"{}\" and \"{}\" overlap by {:.6g} m", body_name(scene, overlap.second),
                  body_name(scene, overlap.first), overlap.depth);
  const double far = std::max(farthest(scene, overlap.first), farthest(scene, overlap.second));
  const double digit = std::numeric_limits<double>::epsilon() * far;
  if (overlap.depth <= few_digits * digit) {
    text += fmt::format(
        ": coordinates of {:.3g} m have no digits below {:.1g} m, so bodies this small cannot "
        "touch "
        "there; nearer to the origin they can",
        far, digit);
  }
  return text;
}

}  // namespace wuerfel
