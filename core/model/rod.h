/// Rods (Stangen) of one's own: Eq. (1) between places of different bodies, or to a place that is fixed.
#pragma once

#include <string>
#include <vector>

#include "core/geometry/vec2.h"

namespace wuerfel {

/// A place that a rod holds.
struct RodEnd {
  int body = -1;  ///< number of the body, which moves; -1: fixed in the world
  Vec2 at =
      Vec2::Zero();  ///< m, in the frame of the unturned body from its centre, or in the world
  int name = -1;     ///< Body::number of the body, also of one that is fixed; -1: none
};

/// One equality between two places. A pin is two of them, one after the other: rods without length
/// along x and y.
struct Rod {
  enum class Kind { rod, pin_x, pin_y };
  Kind kind = Kind::rod;
  RodEnd i;             ///< `from` of the scene
  RodEnd j;             ///< `to`
  double length = 0.0;  ///< m; 0 of pins
  std::string name;
  int number = 0;  ///< in the whole scene, also where only a part of it is looked at
};

/// Whether one end is fixed.
inline bool is_held(const Rod& rod) { return rod.i.body < 0 || rod.j.body < 0; }

}  // namespace wuerfel
