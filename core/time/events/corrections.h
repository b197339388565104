/// Positions and velocities are put right at an event: out of what bodies overlap by, which is
/// rounding, and onto the contacts that stay closed. Both return what has to change.
#pragma once

#include <vector>

#include "core/time/events/workspace.h"

namespace wuerfel {

struct OutOfOverlap {
  std::vector<Twist> displacements;  ///< m, rad, one per cube of the system; empty: none are needed
  bool pushed = false;               ///< contacts took part that are in none of the islands
};
/// Displacements that remove what bodies overlap by, so that it cannot add up. `islands` are those
/// of `state`, found with `touching` (a share of the smaller side); those of cubes that all rest
/// (`resting`, one per cube) stay as they are. A light body between others may have to move by more
/// than rounding, into what it did not touch before: that takes part then as well.
OutOfOverlap out_of_overlap(const State& state,
                            const std::vector<Island>& islands,
                            const std::vector<char>& resting,
                            double touching,
                            Workspace& work);

/// Changes of one island, one entry per cube; empty where nothing has to change.
struct OntoClosed {
  std::vector<Twist> displacements;  ///< m, rad
  std::vector<Twist> velocities;     ///< m/s, rad/s; new ones
};
/// Closed contacts (`closed`, one entry per contact of the island) may still have gaps within what
/// counts as touching, and open slowly. The smooth phase makes both zero, which may not push other
/// contacts into overlap or let them close: they take part here, as inequalities.
OntoClosed onto_closed(const Island& island,
                       const State& state,
                       const std::vector<char>& closed,
                       Workspace& work);

/// Whether all cubes of an island rest.
bool all_rest(const Island& island, const std::vector<char>& resting);

/// The contacts of an island as they are at a state.
void follow(const System& system, const State& state, Island& island);

}  // namespace wuerfel
