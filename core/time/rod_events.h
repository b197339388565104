/// What rods do at an instant, as events, and what they fail to do.
#pragma once

#include <span>

#include "core/model/system.h"
#include "core/time/bookkeeping.h"

namespace wuerfel {

/// Adds one event for each rod of a jam: its impulse is what the body at one of its ends has lost of its momentum.
void add_jam_events(const System& system,
                    const State& before,
                    const State& after,
                    std::span<const int> rods,
                    double t,
                    std::vector<Event>& events);

/// Books that rods contradicted each other while nothing was struck: forces go on to drive what they hold, and no
/// motion keeps all lengths.
void note_contradiction(const System& system,
                        std::span<const int> rods,
                        double t,
                        Bookkeeping& book);

/// Names of the rods whose lengths are farther off than is promised.
std::vector<std::string> lost_rods(const System& system, const State& state);

}  // namespace wuerfel
