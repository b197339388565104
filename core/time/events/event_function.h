/// Functions of the motion that are positive until an event happens, and bounds of their
/// derivatives: what must be known of one for its first zero to be found.
///
/// | event                            | function                                  | unit |
/// | bodies meet                      | separation: largest over all sides of the |  m   |
/// |                                  | gap of the nearest corner                 |      |
/// | a corner meets the line of a side| gap, Eq. (2) over |p_j - p_i|             |  m   |
/// | a corner reaches an end of a side| to_start, to_end: distance along the side |  m   |
/// | a contact lets go                | its load (force_events.h)                 |  N   |
#pragma once

#include "core/constraints/contact.h"
#include "core/constraints/side.h"
#include "core/time/events/first_zero.h"

namespace wuerfel {

/// Share of the smaller side up to which bodies touch at an event.
inline constexpr double event_touching = 1e-10;

/// Where a body is and how it moves. A plane is a box without extent, of which `plane_side` faces
/// out.
struct MovingBox {
  Box box;
  Vec2 velocity = Vec2::Zero();  ///< m/s
  double spin = 0.0;             ///< rad/s
  Twist acceleration;            ///< m/s^2, rad/s^2; where it is known
};
inline constexpr int plane_side = 2;

/// A fixed body.
MovingBox fixed_body(const Body& body);

struct EventFunction {
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
  Arming arming{};

  [[nodiscard]] IndexPair pair() const { return std::minmax(on, from); }
};

/// One of the sides of a pair of boxes.
struct PairSide {
  bool of_on = false;  ///< of `on`, else of `from`
  int side = 0;
  bool operator==(const PairSide&) const = default;
};

/// Two bodies at one moment.
struct MovingPair {
  MovingBox on;
  MovingBox from;
};

/// A corner of `on` across (gap) or along a side of `from`: m, m/s, m/s^2.
Jet corner_at_side(
    const MovingBox& on, int corner, const MovingBox& from, int side, EventFunction::Kind kind);

/// The side of a pair that separates it best.
PairSide separating_side(const MovingPair& pair);
/// The gap of corner k of the other body from such a side.
Jet gap_of_corner(const MovingPair& pair, const PairSide& side, int k);
/// The separation of a pair by such a side: the gap of the nearest corner.
Jet separation_by(const MovingPair& pair, const PairSide& side);

/// Range of a cube's accelerations within a step.
struct TwistRange {
  Twist low;
  Twist high;
};

/// A body within a part of a step.
struct Travel {
  const MovingBox* begin = nullptr;
  const MovingBox* end = nullptr;
  TwistRange range;  ///< within the whole step
  bool still = false;
};

/// Accelerations, taken from the stages of a step, have this much in reserve in all bounds.
inline constexpr double acceleration_reserve = 1.5;

/// Bounds (m/s^2, m/s^3) for the corners of `on` across and along the sides of `from` within `part`
/// s of a step of `step` s.
DerivativeBounds bounds_of_corners(const Travel& on, const Travel& from, double part, double step);

}  // namespace wuerfel
