/// Layers: what a picture shows.
#pragma once

#include <string>
#include <string_view>

#include "render/picture/enum_set.h"

namespace wuerfel {

enum class Layer {
  cubes,    ///< cubes, points, rods between bodies, pins, fixed boxes and the ground
  rods,     ///< the rods that keep a cube stiff (Figure 2 of the paper); those between bodies
  points,   ///< point masses, area proportional to mass (Figure 7)
  sides,    ///< the triangle of Eq. (2) with its sign (Figures 3 and 4)
  normals,  ///< unit normals of the contacts
  forces,   ///< what bodies do to each other, one arrow for each touching face; impacts
  contact_forces,  ///< the same corner by corner, friction apart
  joints,          ///< pressure along each touching face, and its sum in numbers
  thrust,          ///< where the forces run through the bodies, and hinges
  whiskers,        ///< what forces that are not the only possible ones could be instead
  weights,         ///< m g of each cube
  accelerations,   ///< Gauss' answer: accelerations of centres, and of corners that turn
  mechanism,       ///< the motion that proves that nothing holds what falls: displaced outlines
  causes,          ///< the parts that fail by themselves, and over which corner
  rod_forces,      ///< rods coloured and thickened by tension or compression
  velocities,      ///< velocities of the cubes as arrows
  trails,          ///< the paths of the centres up to now
  contacts,        ///< touching points
  grid,            ///< lines at round metres
  names,           ///< names of the bodies
  values,          ///< numbers beside force arrows
  symbols,         ///< the paper's p_i, p_j, p_k, alpha, n, v_k, A and m where they stand
  hud,             ///< title, time, energy, scale bar, legend
  instances,       ///< nothing else: each body in a colour that is its number
};

using Layers = EnumSet<Layer>;

constexpr Layers default_layers{Layer::cubes, Layer::forces, Layer::hud};

std::string_view to_string(Layer layer);

/// The names in the order of the enum, with commas.
std::string to_string(Layers layers);

/// What a legend explains. Chosen once for a run, so that it stands still.
enum class LegendEntry {
  contact,   ///< a force across a face
  friction,  ///< a force along it, where forces are drawn corner by corner
  cut,       ///< forces longer than they are drawn
  hidden,    ///< forces too small for an arrow: dots
  several,   ///< forces that are not the only possible ones: hollow
  impact,    ///< rings
  range,     ///< whiskers
  mechanism,
  cause,
  above,     ///< loads or speeds beyond the last colour
  negative,  ///< a corner behind its side
  beyond,    ///< whiskers longer than they are drawn
};

using Legend = EnumSet<LegendEntry>;

std::string_view to_string(LegendEntry entry);
std::string to_string(Legend legend);

}  // namespace wuerfel
