/// A part of a system: some of its cubes, and everything that is fixed.
#pragma once

#include <vector>

#include "core/model/system.h"

namespace wuerfel {

/// The system without the cubes that are not named, `cubes` in ascending order. Of its rods those that
/// join cubes of the part, or a cube of it and a fixed place.
System part_of(const System& whole, const std::vector<int>& cubes);
/// The same with other cubes, `standing`, as fixed boxes where they are at a state. They are numbered after `cubes`, before what
/// is fixed anyway.
System part_on(const System& whole,
               const std::vector<int>& cubes,
               const std::vector<int>& standing,
               const State& state);

}  // namespace wuerfel
