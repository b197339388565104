/// Bodies that overlap.
#pragma once

#include <optional>
#include <string>

#include "core/scene/scene.h"

namespace wuerfel {

enum class BodyKind { plane, fixed, cube, point };

/// A body of a scene: index into Scene::planes, fixed, cubes or points.
struct BodyRef {
  BodyKind kind = BodyKind::cube;
  int index = 0;
  bool operator==(const BodyRef&) const = default;
  bool operator<(const BodyRef& other) const {
    return kind < other.kind || (kind == other.kind && index < other.index);
  }
};

const std::string& body_name(const Scene& scene, const BodyRef& body);

struct Overlap {
  BodyRef first;       ///< the lesser of the two: planes before fixed boxes before cubes
  BodyRef second;      ///< always a cube or a point
  double depth = 0.0;  ///< m, how far one of them would have to be moved
};

/// An overlap deeper than touching that a cube or a point takes part in; the first one from the left
/// (or from below, for scenes taller than wide), nothing if there is none. Planes and fixed boxes may
/// overlap among themselves, and bodies that a pin joins. Sort and sweep over the boxes' bounds, separating axes for the pairs.
std::optional<Overlap> find_overlap(const Scene& scene);

/// `"b" and "a" overlap by 0.25 m`, or `the point "p" lies 0.25 m inside of "a"`
std::string overlap_message(const Scene& scene, const Overlap& overlap);

}  // namespace wuerfel
