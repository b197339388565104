/// Tables of a scene text that make many cubes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/entry_parts.h"

namespace wuerfel {

/// Axis-aligned rectangle [xmin, ymin, xmax, ymax].
struct Region {
  Vec2 low = Vec2::Zero();   ///< m
  Vec2 high = Vec2::Zero();  ///< m
};

/// What a text may say; `choices` has the names in order.
enum class Bond { running, stack };
constexpr std::array<std::string_view, 2> choices(Bond /*type*/) { return {"running", "stack"}; }

struct TowerEntry : BrickEntry {
  std::int64_t count = 0;
  StandingEntry standing;
  double lean = 0.0;  ///< m
};

struct WallEntry : BrickEntry {
  std::int64_t rows = 0;
  std::int64_t columns = 0;
  Bond bond = Bond::running;
  StandingEntry standing;
};

struct PyramidEntry : BrickEntry {
  std::int64_t rows = 0;
  StandingEntry standing;
};

struct PileEntry : BrickEntry {
  std::int64_t count = 0;
  Region region;
  std::int64_t seed = 1;
};

inline constexpr std::string_view base_doc = "m, middle of the lowest edge";

template <class Keys>
void describe(Keys& keys, TowerEntry& tower) {
  describe_brick(keys, tower,
                 "Default tower1, tower2, ...; its cubes are tower1_1, tower1_2, ... from below");
  keys.required("count", tower.count, limits::count, "Number of cubes");
  describe_standing(keys, tower.standing, "base", base_doc);
  keys.value("lean", tower.lean, limits::coordinate, "m, shift of each cube against the one below");
}

template <class Keys>
void describe(Keys& keys, WallEntry& wall) {
  describe_brick(
      keys, wall,
      "Default wall1, wall2, ...; its cubes are wall1_1, ... row by row from the lower left");
  keys.required("rows", wall.rows, limits::count, "Number of rows");
  keys.required("columns", wall.columns, limits::count, "Cubes in a full row");
  keys.value("bond", wall.bond,
             "running: every second row is shifted by half a cube, with half cubes at its ends "
             "(mass by area); "
             "stack: columns");
  describe_standing(keys, wall.standing, "base", base_doc);
}

template <class Keys>
void describe(Keys& keys, PyramidEntry& pyramid) {
  describe_brick(keys, pyramid,
                 "Default pyramid1, pyramid2, ...; its cubes are pyramid1_1, ... row by row from "
                 "the lower left");
  keys.required("rows", pyramid.rows, limits::count,
                "Number of rows; the lowest has as many cubes, each next one less");
  describe_standing(keys, pyramid.standing, "base", base_doc);
}

template <class Keys>
void describe(Keys& keys, PileEntry& pile) {
  describe_brick(keys, pile, "Default pile1, pile2, ...; its cubes are pile1_1, pile1_2, ...");
  keys.required("count", pile.count, limits::count, "Number of cubes");
  keys.required("region", pile.region, limits::coordinate,
                "m, [xmin, ymin, xmax, ymax]: the cubes are put into it at random places and "
                "angles, clear of each "
                "other and of all other bodies");
  keys.value("seed", pile.seed, limits::seed, "The same seed gives the same pile on every machine");
}

}  // namespace wuerfel
