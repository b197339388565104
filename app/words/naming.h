/// What bodies, parts, directions and corners are called.
#pragma once

#include <string>
#include <vector>

#include "app/words/language.h"
#include "core/statics/still_scene.h"

namespace wuerfel {

/// A part names its cubes one by one up to so many.
constexpr std::size_t most_names = 3;

std::vector<std::string> names_of(const StillScene& still, const std::vector<int>& bodies);

/// Of cubes that go together; of many the one that carries them, `base`, stands for all.
std::string part_name(const StillScene& still,
                      const std::vector<int>& cubes,
                      int base,
                      Language language);

std::string side_name(int sense, Language language);
std::string way_name(int sense, Language language);

/// Up, down, left or right, whichever a direction is nearest to.
Phrase direction_of(const StillScene& still, const Vec2& v);

/// Of a cube, as its sides lie: of a slender one that leans two are below its middle to the right.
Phrase corner_of(const StillScene& still, int cube, const Vec2& point);

}  // namespace wuerfel
