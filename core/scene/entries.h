/// The scene format, said once: the tables of a scene text as plain structs, and for each of them
/// `describe`, which lists its keys with their range, default and meaning. Reading (table_reader),
/// the suggestions for misspelt keys and the JSON Schema (schema) are visitors of these lists.
///
/// A visitor `keys` offers
///   value(key, target, limits, doc)   an optional key; the target's present value is the default
///   required(key, target, limits, doc)
///   table(key, entry, doc), tables(key, entries, doc)   a sub-table, an array of tables
///   exactly_one, at_most_one, at_least_one ({keys})     alternatives
///   needs(key, other)                                   `key` only together with `other`
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/scene/body_entries.h"
#include "core/scene/generator_entries.h"
#include "core/scene/linkage_entries.h"

namespace wuerfel {

struct SceneEntries {
  std::int64_t version = 1;
  std::string title;
  Vec2 gravity{0.0, -9.81};
  double duration = 5.0;
  Material material;
  std::vector<PlaneEntry> planes;
  std::vector<FixedEntry> fixed;
  std::vector<CubeEntry> cubes;
  std::vector<TowerEntry> towers;
  std::vector<WallEntry> walls;
  std::vector<PyramidEntry> pyramids;
  std::vector<PileEntry> piles;
  std::vector<PairEntry> pairs;
  std::vector<PointEntry> points;
  std::vector<RodEntry> rods;
  std::vector<PinEntry> pins;
  std::vector<ChainEntry> chains;
  std::vector<TrussEntry> trusses;
};

template <class Keys>
void describe(Keys& keys, SceneEntries& scene) {
  keys.value("version", scene.version, Limits{1.0, 1.0}, "Version of the scene format");
  keys.value("title", scene.title, limits::title, "Shown in pictures");
  keys.value("gravity", scene.gravity, limits::rate, "m/s^2");
  keys.value("duration", scene.duration, limits::duration, "s, simulated time");
  keys.table("material", scene.material, "Defaults for all bodies, planes and fixed boxes too");
  keys.tables("plane", scene.planes, "Fixed half-planes");
  keys.tables("fixed", scene.fixed, "Fixed boxes");
  keys.tables("cube", scene.cubes, "Cubes: uniform rigid rectangles");
  keys.tables("tower", scene.towers, "Generator: cubes on top of each other");
  keys.tables("wall", scene.walls, "Generator: rows of cubes");
  keys.tables("pyramid", scene.pyramids, "Generator: rows that get shorter by one cube");
  keys.tables("pile", scene.piles, "Generator: cubes scattered at random");
  keys.tables("pair", scene.pairs, "Surface properties of one pair of bodies");
  keys.tables("point", scene.points, "Point masses");
  keys.tables("rod", scene.rods, "Rods: each keeps two places at their distance");
  keys.tables("pin", scene.pins,
              "Pins: each keeps two places that coincide together; its two bodies don't touch each "
              "other");
  keys.tables("chain", scene.chains, "Generator: a chain of point masses or cubes");
  keys.tables("truss", scene.trusses, "Generator: a plane truss of points and rods");
  keys.at_least_one({"cube", "tower", "wall", "pyramid", "pile", "point", "chain", "truss"});
}

}  // namespace wuerfel
