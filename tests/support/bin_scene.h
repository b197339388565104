/// Squares dropped in a bin: the crowd of the tests.
#pragma once

#include <string>

#include "core/scene/scene_parser.h"

namespace wuerfel::test {

/// `count` unit squares at places and angles by `seed`, up to the height `top` (m), above a floor
/// between two fixed walls `width` m apart.
inline Scene bin_scene(int count, double width, double top, int seed) {
  const auto number = [](double x) { return std::to_string(x); };
  const double wall = 0.5 * width + 0.25;
  const double inside = 0.5 * width - 0.05;
  return parse_scene("version = 1\n[[plane]]\n[[fixed]]\nsize = [0.5, 60]\nposition = ["
                         + number(-wall) + ", 30]\n[[fixed]]\nsize = [0.5, 60]\nposition = ["
                         + number(wall) + ", 30]\n[[pile]]\ncount = " + std::to_string(count)
                         + "\nregion = [" + number(-inside) + ", 0.5, " + number(inside) + ", "
                         + number(top) + "]\nseed = " + std::to_string(seed) + "\n",
                     "bin.toml");
}

}  // namespace wuerfel::test
