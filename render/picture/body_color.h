/// What the colours of bodies say.
#pragma once

#include <string_view>
#include <vector>

#include "core/snapshot.h"
#include "render/picture/style.h"

namespace wuerfel {

enum class ColorBy {
  body,   ///< each its own
  load,   ///< the sum of the forces that carry it, N, in films over a moment
  speed,  ///< of the centre, m/s
  island  ///< bodies that push one another have one colour
};
std::string_view to_string(ColorBy by);

struct BodyColoring {
  ColorBy by = ColorBy::body;
  double top = 0.0;  ///< N or m/s, the end of the scale; 0: the frame's largest
};

/// A colour of the scale of loads and speeds: 0 .. 1 from little to much, even in brightness
/// (viridis by S. van der Walt and N. Smith, without its darkest tenth; greys for print).
Color scale_color(const Style& style, double share);

/// N, of each box: the sum of the joints that carry it.
std::vector<double> joint_loads(const Snapshot& snapshot);
/// The same over a moment, where that is known.
std::vector<double> loads(const Snapshot& snapshot);

/// The largest load or speed of a cube; 0 where colours are no numbers.
double largest_value(const Snapshot& snapshot, ColorBy by);

/// One for each box.
std::vector<Color> body_colors(const Snapshot& snapshot,
                               const Style& style,
                               const BodyColoring& coloring);

}  // namespace wuerfel
