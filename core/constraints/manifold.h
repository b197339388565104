/// The contact manifold: corners and sides by which two boxes touch, or are about to. Its rules are
/// those of the design, section 1.
#pragma once

#include <span>
#include <vector>

#include "core/constraints/contact.h"

namespace wuerfel {

/// The contact of corner k of box `on` with side e of box `from`.
Contact corner_on_side(int on, const Box& b, int k, int from, const Box& a, int e);

/// Adds the contacts of boxes i and j that touch within `tolerance` (m); returns their separation.
double add_touching_contacts(const System& system,
                             const State& state,
                             std::span<const Box> boxes,
                             int i,
                             int j,
                             double tolerance,
                             std::vector<Contact>& contacts);

}  // namespace wuerfel
