/// Events without an impulse: contacts that came or went.
#pragma once

#include <vector>

#include "core/time/bookkeeping.h"
#include "core/time/events/contact_modes.h"

namespace wuerfel {

/// Adds releases, corners that slid off the end of a side, and touches to the events of an instant:
/// what closed contacts pairs have in the phase that begins (`after`) and had not in the one that
/// ended (`before`), and the other way round. What touched already is no touch, closed or not.
/// Pairs that rest and pairs that an event of this instant names are left out.
void add_contact_changes(const System& system,
                         const ContactModes& before,
                         const ContactModes& after,
                         double t,
                         std::vector<Event>& events);

}  // namespace wuerfel
