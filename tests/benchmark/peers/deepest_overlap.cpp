#include "tests/benchmark/peers/deepest_overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace wuerfel::bench {

namespace {

struct Rectangle {
  std::array<Vec2, 4> corners;
  std::array<Vec2, 2> axes;
  Vec2 low, high;  ///< of the box around it
};

Rectangle rectangle(const Vec2& centre, double angle, const Vec2& size) {
  Rectangle r;
  r.axes = {Vec2(std::cos(angle), std::sin(angle)), Vec2(-std::sin(angle), std::cos(angle))};
  const Vec2 a = 0.5 * size.x() * r.axes[0];
  const Vec2 b = 0.5 * size.y() * r.axes[1];
  r.corners = {centre - a - b, centre + a - b, centre + a + b, centre - a + b};
  r.low = r.high = centre;
  for (const Vec2& corner : r.corners) {
    r.low = r.low.cwiseMin(corner);
    r.high = r.high.cwiseMax(corner);
  }
  return r;
}

// How far one must be moved along the axis until they part.
double depth_along(const Vec2& axis, const Rectangle& a, const Rectangle& b) {
  std::array<double, 4> range{1e300, -1e300, 1e300, -1e300};
  for (int k = 0; k < 4; ++k) {
    const auto i = static_cast<std::size_t>(k);
    range[0] = std::min(range[0], axis.dot(a.corners[i]));
    range[1] = std::max(range[1], axis.dot(a.corners[i]));
    range[2] = std::min(range[2], axis.dot(b.corners[i]));
    range[3] = std::max(range[3], axis.dot(b.corners[i]));
  }
  return std::min(range[1] - range[2], range[3] - range[0]);
}

double depth(const Rectangle& a, const Rectangle& b) {
  if ((a.low.array() >= b.high.array()).any() || (b.low.array() >= a.high.array()).any())
    return 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2& axis : {a.axes[0], a.axes[1], b.axes[0], b.axes[1]})
    least = std::min(least, depth_along(axis, a, b));
  return std::max(least, 0.0);
}

}  // namespace

double deepest_overlap(const Scene& scene, const State& state) {
  std::vector<Rectangle> cubes;
  for (std::size_t i = 0; i < state.size(); ++i)
    cubes.push_back(rectangle(state[i].position, state[i].angle, scene.cubes[i].size));
  std::vector<Rectangle> fixed;
  for (const SceneFixed& box : scene.fixed)
    fixed.push_back(rectangle(box.position, box.angle, box.size));
  double deepest = 0.0;
  for (std::size_t i = 0; i < cubes.size(); ++i) {
    for (std::size_t k = i + 1; k < cubes.size(); ++k)
      deepest = std::max(deepest, depth(cubes[i], cubes[k]));
    for (const Rectangle& box : fixed)
      deepest = std::max(deepest, depth(cubes[i], box));
    for (const ScenePlane& plane : scene.planes)
      for (const Vec2& corner : cubes[i].corners)
        deepest = std::max(deepest, plane.normal.dot(plane.point - corner));
  }
  return deepest;
}

}  // namespace wuerfel::bench
