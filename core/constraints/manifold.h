/// The contact manifold: corners and sides by which two boxes touch, or are about to. Its rules are
/// those of the design, section 1.
#pragma once

#include <span>
#include <vector>

#include "core/constraints/contact.h"

namespace wuerfel {

/// The contact of corner k of box `on` with side e of box `from`.
Contact corner_on_side(int on, const Box& b, int k, int from, const Box& a, int e);

/// Adds the contacts of boxes i and j that touch within `tolerance` (m), and the touch that they
/// make; returns their separation.
double add_touching_contacts(const System& system,
                             const State& state,
                             std::span<const Box> boxes,
                             int i,
                             int j,
                             double tolerance,
                             std::vector<Contact>& contacts,
                             std::vector<Touch>& touches);

/// The corner and the side that separate two boxes best: where the gap between them is measured,
/// touching or not.
Contact nearest_corner(std::span<const Box> boxes, int i, int j);

/// One of the sides of a pair of boxes.
struct FacingSide {
  int from = 0;  ///< body of the side
  int on = 0;    ///< the other one
  int side = 0;
  double separation = 0.0;  ///< m, of the bodies along it; negative where they overlap
};

/// The side that keeps a pair apart longest while it moves from `start` to `end`: one that
/// separates it at both, the more the better; else of those that separate it at the start the one
/// whose gap closes last, for that is where the bodies meet.
FacingSide separating_side(std::span<const Box> start, std::span<const Box> end, int i, int j);

/// Corners by which a pair would meet at a side: the nearest corner, or both ends of the overlap
/// where the facing sides are within `flush` (sine of the angle between them).
void add_near_contacts(std::span<const Box> boxes,
                       const FacingSide& side,
                       double flush,
                       std::vector<Contact>& contacts);

}  // namespace wuerfel
