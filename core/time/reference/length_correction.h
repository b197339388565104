/// "Eventuell Längenkorrektur": what a step of Algorithm 1 leaves open. Corners are moved out of
/// sides, and sides that carried load stay closed.
#pragma once

#include <vector>

#include "core/dynamics/push.h"
#include "core/time/bookkeeping.h"
#include "core/time/workspace.h"

namespace wuerfel {

/// Moves the cubes by the least that removes overlap and keeps the contacts in `pressed` closed;
/// then changes velocities by the least that makes the gap rates of these zero. What fixed bodies
/// gave the cubes by that, which is no impulse of a program, is settled by them; nothing where none
/// was pressed and no rod is held.
Push correct_lengths(State& state,
                     const std::vector<Contact>& pressed,
                     Workspace& work,
                     Bookkeeping& book);

}  // namespace wuerfel
