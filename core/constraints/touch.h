/// A touch: two bodies and how they touch. Whether sides are flush is decided when a touch is found
/// (manifold.cpp); everybody else asks the touch.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/geometry/broad_phase.h"
#include "core/model/system.h"

namespace wuerfel {

struct Contact;

/// A part of a side, m from its p_i towards its p_j.
struct Interval {
  double low = 0.0;
  double high = 0.0;
  [[nodiscard]] double length() const { return high - low; }
};

/// Two bodies that touch. Its contacts are `count` neighbours in the list of contacts that the
/// touch belongs to (a finder's, an island's, a smooth phase's), from `first` on.
///
///     corner_on_side      flush                  on_plane
///        /\                +-----+                +-----+
///       /on\               | on  |                | on  |
///       \  /               1-----2                1-----2
///     +--1--+---+        +-+---+-+               ~~~~~~~~~~~
///     |  from   |        |from |
struct Touch {
  enum class Kind {
    corner_on_side,  ///< one contact
    flush,           ///< side on side: two contacts, at the ends of the overlap or, where both stay
                     ///< closed (closed_rows), at the ends of the shorter side
    on_plane,        ///< one corner or two of them
  };
  Kind kind = Kind::corner_on_side;
  int on = 0;  ///< bodies of corner and side of the first contact
  int from = 0;
  int side = 0;     ///< number of the side of `from`
  int facing = -1;  ///< where flush: number of the side of `on` that lies on it
  int first = 0;
  int count = 1;
  Material surface{};
  /// Coulomb's law between events, of closed touches that rub: they stick, or slip in a known
  /// direction, +1 or -1 along perp(normal), seen from the side.
  bool sticks = false;
  int slips = 0;
  bool idle = false;    ///< slips, and needs no force to stay closed
  double anchor = 0.0;  ///< m, place_along where it sticks

  [[nodiscard]] IndexPair pair() const { return std::minmax(on, from); }
};

/// The part of the side on which a touch of closed contacts bears, as the contacts are now: the
/// overlap of flush sides; at a corner both ends are its foot.
Interval overlap_of(const Touch& touch, std::span<const Contact> contacts);

/// Where the corner of a contact is along perp(normal), m, seen from the side: on the side, or from
/// the origin on a plane, which has no ends.
double place_along(const System& system, const Contact& contact);

/// Loads of closed touches, from the forces (N) of all contacts: what must stay positive for them
/// to stay closed. One for each contact at a corner or on a plane; where sides are flush two, at
/// the ends of the overlap, by the law of the lever.
void find_loads(std::span<const Touch> touches,
                std::span<const Contact> contacts,
                std::span<const double> forces,
                std::vector<double>& loads);

/// Contacts and the touches that they belong to.
struct ContactSet {
  std::vector<Contact> contacts;
  std::vector<Touch> touches;
};

/// Adds the rows of a touch of which the contacts with `closed` stay closed. Flush sides get both
/// corners of the shorter side on the line of the longer one: the ends of the overlap say the same
/// but may lie close to each other, corners never do.
void add_closed_rows(const System& system,
                     std::span<const Box> boxes,
                     const Touch& touch,
                     std::span<const Contact> contacts,
                     std::span<const char> closed,
                     ContactSet& rows);

}  // namespace wuerfel
