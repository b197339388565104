/// "Bestimme die aktiven Restriktionen": what touches at a grid point, the impacts that are due there
/// (the paper has no law for them), and what rests.
#pragma once

#include "core/time/bookkeeping.h"
#include "core/time/reference/grid_point.h"
#include "core/time/workspace.h"

namespace wuerfel {

/// Contacts of a state that was just reached, and its impacts. `point` still has the contacts of
/// the grid time before.
void find_restrictions(GridPoint& point, Workspace& work, Bookkeeping& book);
/// "Bestimme (a_i)": Eq. (9) under (1), and under (7) where (2) = (3) = 0; once for each point.
void accelerate(GridPoint& point, Workspace& work, Bookkeeping& book);

}  // namespace wuerfel
