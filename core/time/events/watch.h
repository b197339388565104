/// Functions of a motion whose zeros are events, read at one instant.
#pragma once

#include "core/constraints/contact.h"

namespace wuerfel {

/// Where a body is and how it moves.
struct MovingBox {
  Box box;
  Vec2 velocity = Vec2::Zero();
  double spin = 0.0;
  Twist acceleration;  ///< where it is known
};

/// A function of the motion that is positive until an event happens.
struct Watch {
  enum class Kind {
    separation,  ///< of two boxes that do not touch, over all sides
    gap,         ///< of a corner from the line of a side
    to_start,    ///< of a corner along a side, from the side's p_i
    to_end,      ///< of a corner along a side, to the side's p_j
  };
  Kind kind = Kind::separation;
  int on = 0;  ///< body of the corner; of a separation the body with the smaller number
  int from = 0;
  int corner = 0;
  int side = 0;
  double shift = 0.0;  ///< m; added until the function has left zero, where it starts from there

  [[nodiscard]] bool same_place(const Watch& o) const {
    return kind == o.kind && on == o.on && from == o.from && corner == o.corner && side == o.side;
  }
};

/// A watched function, with its shift: value (m) and derivatives.
struct Reading {
  double value = 0.0;
  double rate = 0.0;  ///< m/s
  double bend = 0.0;  ///< m/s^2; where accelerations are known
};

/// Reading of a corner of `on` against side `side` of `from`.
Reading read_corner(
    const MovingBox& on, int corner, const MovingBox& from, int side, Watch::Kind kind);

/// A watched function at one moment of a step.
struct Look {
  double share = 0.0;
  Reading reading;
  MovingBox on;
  MovingBox from;
  int pair_side = 0;  ///< the side that separates: 0 .. 3 of `from`, 4 .. 7 of `on`
};

/// Separation of two boxes, and the rate of the corner that is nearest to the side that separates.
Look look_at_separation(const MovingBox& from, const MovingBox& on, double share);

/// Reading of corner k of the other body against side `pair_side` of a pair.
Reading read_pair_side(const Look& look, int pair_side, int k);

}  // namespace wuerfel
