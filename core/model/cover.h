/// What of a fixed box nothing can touch, since other fixed bodies cover it: the sides of a seam between flush tiles
/// and the corners at it. Normals and corners there would stop what slides over the seam.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "core/geometry/box.h"

namespace wuerfel {

/// Alphas of Eq. (5) that are closer than this are one place.
inline constexpr double same_alpha = 1e-9;

struct Cover {
  /// Per side the covered intervals of Eq. (5)'s alpha.
  std::array<std::vector<std::pair<double, double>>, Box::corners> side;

  /// Whether side e is covered at alpha. The ends of an interval are not, unless they are those of the side.
  [[nodiscard]] bool covers(int e, double alpha) const;
  /// Whether corner k is one of the seam: one of its two sides is covered there.
  [[nodiscard]] bool covers_corner(int k) const {
    return covers(k, 1.0) || covers(previous_corner(k), 0.0);
  }
  [[nodiscard]] bool empty() const;
};

/// Adds what `other`, a fixed box, covers of `box`.
void add_cover(const Box& box, const Box& other, Cover& cover);
/// Adds what lies in the half-plane at `point` with unit `normal` out of the solid.
void add_cover(const Box& box, const Vec2& point, const Vec2& normal, Cover& cover);

}  // namespace wuerfel
