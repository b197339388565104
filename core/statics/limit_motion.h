/// The end of what a moved scene bears, to the last digits.
#pragma once

#include <optional>

#include "core/statics/carried.h"

namespace wuerfel {

/// Beyond the end the scene falls in a motion that presses on some contacts, S. d(s), what the rows of S
/// leave of gravity if they are kept as equalities, is that motion beyond the end and zero at the end,
/// and it is smooth in s: its part along the motion has a simple zero there, found by secants. From a
/// place just before and one behind the end; none where something rubs, or where the zero lies farther
/// away than these two.
std::optional<double> end_of_rest(const StillScene& still,
                                  const MotionSettings& settings,
                                  const CarriedGroup& group,
                                  double before,
                                  double behind);

/// Where a corner of the group comes to a corner of what it touches at `before`, no farther than `room`
/// from there: the end of a face that they share.
std::optional<double> end_of_touch(const StillScene& still,
                                   const CarriedGroup& group,
                                   double before,
                                   double room);

/// Where the group meets what bars its way: overlaps grow evenly from there. From two places behind.
std::optional<double> end_of_room(const StillScene& still,
                                  const MotionSettings& settings,
                                  const CarriedGroup& group,
                                  double behind,
                                  double farther);

}  // namespace wuerfel
