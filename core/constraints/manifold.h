/// The contact manifold: corners and sides by which two boxes touch, or are about to. Its rules are
/// those of the design, section 1.
#pragma once

#include <span>
#include <vector>

#include "core/constraints/contact.h"

namespace wuerfel {

/// The contact of corner k of box `on` with side e of box `from`.
Contact corner_on_side(int on, const Box& b, int k, int from, const Box& a, int e);

/// Adds the contacts of a pair of boxes that touch within `tolerance` (m), and the touch that they
/// make; returns their separation.
double add_touching_contacts(const System& system,
                             const State& state,
                             std::span<const Box> boxes,
                             const IndexPair& pair,
                             double tolerance,
                             std::vector<Contact>& contacts,
                             std::vector<Touch>& touches);

/// The corner of `on` that is deepest below a side of `from`.
Contact deepest_corner_at(std::span<const Box> boxes, int from, int on, int side);

/// The corner and the side that separate two boxes best: where the gap between them is measured,
/// touching or not.
Contact nearest_corner(std::span<const Box> boxes, int i, int j);

/// Whether a contact is at a side or a corner that fixed bodies cover.
bool is_covered(const System& system, const Contact& contact);

/// One of the sides of a pair of boxes.
struct FacingSide {
  int from = 0;  ///< body of the side
  int on = 0;    ///< the other one
  int side = 0;
  double separation = 0.0;  ///< m, of the bodies along it; negative where they overlap
};

/// Where boxes are at the start of a step, where their velocities alone would take them, and at the
/// end of the way that is looked at.
struct Way {
  std::span<const Box> start;
  std::span<const Box> drift;
  std::span<const Box> end;
};

/// The side that keeps a pair apart longest on its way: one that separates it at the start and the
/// end, the more the better; else one along which velocities alone bring the bodies nearer to each
/// other by no more than `slow` (m): what is carried by others does not fall; else of those that
/// separate the pair at the start the one whose gap closes last, for that is where the bodies meet.
/// What fixed bodies cover of one another is no side.
FacingSide separating_side(const System& system, const Way& way, double slow, int i, int j);

/// Corners by which a pair would meet at a side: the nearest corner, or both ends of the overlap
/// where the facing sides are within `flush` (sine of the angle between them).
void add_near_contacts(std::span<const Box> boxes,
                       const FacingSide& side,
                       double flush,
                       std::vector<Contact>& contacts);

}  // namespace wuerfel
