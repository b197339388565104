/// What looks at a motion cost. None of it is part of what the motion costs.
#pragma once

namespace wuerfel {

struct LookCost {
  long qp_solves = 0;
  long force_choices = 0;  ///< islands for which the forces to show were chosen
  long skipped_free = 0;   ///< cubes that touch nothing
  long unchanged = 0;      ///< islands that were as they had been at the last look
};

}  // namespace wuerfel
