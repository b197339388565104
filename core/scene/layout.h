/// The cubes of the generators [[tower]], [[wall]] and [[pyramid]] in their own coordinates.
#pragma once

#include <vector>

#include "core/scene/entries.h"

namespace wuerfel {

/// A cube of a group; the group's origin is the middle of its lowest edge, x along that edge, y up
/// from it.
struct Brick {
  Vec2 center = Vec2::Zero();  ///< m
  Vec2 size = Vec2::Ones();    ///< m
  double share = 1.0;  ///< of the mass of a full cube: 1/2 for the half cubes of a running bond
};

/// From below, each shifted by `lean` against the one before.
std::vector<Brick> tower_layout(const TowerEntry& tower);

/// Row by row from the lower left. In a running bond rows 2, 4, ... begin and end with half cubes.
std::vector<Brick> wall_layout(const WallEntry& wall);

/// Row by row from the lower left: rows, rows - 1, ..., 1 cubes, each row centred on the one below.
std::vector<Brick> pyramid_layout(const PyramidEntry& pyramid);

}  // namespace wuerfel
