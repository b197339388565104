/// Events without an impulse: contacts that came or went.
#pragma once

#include <vector>

#include "core/constraints/contact.h"
#include "core/time/bookkeeping.h"

namespace wuerfel {

/// Books releases, corners that slid off the end of a side, and touches: what closed contacts there
/// are `after` an instant that were not there `before`, and the other way round. Pairs that rest
/// (`resting`, one per cube) and those that an event of this instant names (from `first_event` on)
/// are left out.
void log_changes(const System& system,
                 const std::vector<Contact>& before,
                 const std::vector<Contact>& after,
                 const std::vector<char>& resting,
                 double t,
                 std::size_t first_event,
                 Bookkeeping& book);

}  // namespace wuerfel
