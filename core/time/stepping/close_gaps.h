/// The end of a stepping: what leans on each other touches again.
#pragma once

#include "core/dynamics/projection.h"

namespace wuerfel {

/// Closes what gaps of the `loaded` contacts, which carried load, are left by a step, and takes from
/// velocities what lifting the cubes costs. Leaves the state as it is where these gaps cannot be
/// closed without overlap.
void close_gaps(const std::vector<Contact>& loaded,
                ClosedContacts& closed,
                ContactFinder& finder,
                State& state);

}  // namespace wuerfel
