/// Push: what something does to the momentum of cubes.
#pragma once

#include "core/geometry/vec2.h"

namespace wuerfel {

/// An impulse, or a force, and its moment.
struct Push {
  Vec2 linear = Vec2::Zero();  ///< N s, or N
  double angular = 0.0;        ///< N m s, or N m, about the common centre of the cubes

  Push& operator+=(const Push& more) {
    linear += more.linear;
    angular += more.angular;
    return *this;
  }
};

inline Push operator+(Push a, const Push& b) {
  a += b;
  return a;
}

inline Push operator*(double factor, const Push& push) {
  return {factor * push.linear, factor * push.angular};
}

}  // namespace wuerfel
