#include "core/scene/overlap.h"

#include <algorithm>
#include <limits>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/geometry/bounds.h"

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
  swept.bounds = posed_bounds(swept.box, 0.0);
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
  index = 0;
  for (const ScenePoint& point : scene.points) {
    boxes.push_back(swept_box(point.position, 0.0, Vec2::Zero(), {BodyKind::point, index++}));
  }
  return boxes;
}

/// Sorts along the axis on which the boxes spread more and returns it.
int sort_for_sweep(std::vector<SweptBox>& boxes) {
  BoundingBox all = boxes.front().bounds;
  for (const SweptBox& swept : boxes)
    all.include(swept.bounds);
  const Vec2 spread = all.high - all.low;
  const int axis = spread.x() >= spread.y() ? 0 : 1;
  std::sort(boxes.begin(), boxes.end(), [axis](const SweptBox& a, const SweptBox& b) {
    const double low_a = a.bounds.low[axis];
    const double low_b = b.bounds.low[axis];
    return low_a < low_b || (low_a == low_b && a.body < b.body);
  });
  return axis;
}

bool moves(const BodyRef& body) {
  return body.kind == BodyKind::cube || body.kind == BodyKind::point;
}

/// Names of the bodies that pins join and that don't touch each other.
using PinnedPairs = std::set<std::pair<std::string_view, std::string_view>>;

PinnedPairs pinned_pairs(const Scene& scene) {
  PinnedPairs pairs;
  for (const ScenePin& pin : scene.pins) {
    if (!pin.collide) pairs.insert(std::minmax<std::string_view>(pin.from.body, pin.to.body));
  }
  return pairs;
}

/// Side by which touching is measured, m: points have none.
double side_of(const SweptBox& swept) {
  return swept.box.is_point() ? std::numeric_limits<double>::max() : swept.box.smaller_side();
}

std::optional<Overlap> overlap_of(const SweptBox& a, const SweptBox& b) {
  if (!moves(a.body) && !moves(b.body)) return std::nullopt;
  if (a.box.is_point() && b.box.is_point()) return std::nullopt;
  if (!a.bounds.overlaps(b.bounds)) return std::nullopt;
  const double gap = separation(a.box, b.box);
  const double smaller_side = std::min(side_of(a), side_of(b));
  if (gap >= -touching_tolerance * smaller_side) return std::nullopt;
  return Overlap{std::min(a.body, b.body), std::max(a.body, b.body), -gap};
}

std::optional<Overlap> sweep(const Scene& scene, std::vector<SweptBox>& boxes) {
  const PinnedPairs pinned = pinned_pairs(scene);
  const auto may_overlap = [&](const Overlap& o) {
    return !pinned.empty()
           && pinned.contains(std::minmax<std::string_view>(body_name(scene, o.first),
                                                            body_name(scene, o.second)));
  };
  const int axis = sort_for_sweep(boxes);
  std::vector<const SweptBox*> open;  // boxes that reach to the sweep line
  for (const SweptBox& swept : boxes) {
    std::erase_if(open, [&](const SweptBox* other) {
      return other->bounds.high[axis] < swept.bounds.low[axis];
    });
    for (const SweptBox* other : open) {
      const std::optional<Overlap> overlap = overlap_of(*other, swept);
      if (overlap && !may_overlap(*overlap)) return overlap;
    }
    open.push_back(&swept);
  }
  return std::nullopt;
}

std::optional<Overlap> overlap_with_plane(const Scene& scene, const std::vector<SweptBox>& boxes) {
  for (const SweptBox& swept : boxes) {
    if (!moves(swept.body)) continue;
    int index = 0;
    for (const ScenePlane& plane : scene.planes) {
      const double gap = plane_separation(plane.point, plane.normal, swept.box);
      const double side = swept.box.is_point() ? 1.0 : swept.box.smaller_side();
      if (gap < -touching_tolerance * side) {
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
  const int i = body.index;
  const Vec2& place = body.kind == BodyKind::plane   ? scene.planes[i].point
                      : body.kind == BodyKind::fixed ? scene.fixed[i].position
                                                     : scene.cubes[i].position;
  return place.cwiseAbs().maxCoeff();
}

}  // namespace

const std::string& body_name(const Scene& scene, const BodyRef& body) {
  const int i = body.index;
  if (body.kind == BodyKind::plane) return scene.planes[i].name;
  if (body.kind == BodyKind::fixed) return scene.fixed[i].name;
  return body.kind == BodyKind::cube ? scene.cubes[i].name : scene.points[i].name;
}

std::optional<Overlap> find_overlap(const Scene& scene) {
  std::vector<SweptBox> boxes = swept_boxes(scene);
  if (boxes.empty()) return std::nullopt;
  if (auto overlap = sweep(scene, boxes)) return overlap;
  return overlap_with_plane(scene, boxes);
}

std::string overlap_message(const Scene& scene, const Overlap& overlap) {
  if (overlap.second.kind == BodyKind::point) {
    return fmt::format("the point \"{}\" lies {:.6g} m inside of \"{}\"",
                       body_name(scene, overlap.second), overlap.depth,
                       body_name(scene, overlap.first));
  }
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
