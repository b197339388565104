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

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/vec2.h"
#include "core/scene/color.h"
#include "core/scene/scene.h"
#include "core/scene/value.h"

namespace wuerfel {

/// Range of a number, or of the number of characters of a text; both ends are allowed.
struct Limits {
  double min = 0.0;
  double max = 0.0;
};

/// Bounds leave room for squares and products of what they bound: a scene within them cannot
/// overflow.
namespace limits {
inline constexpr Limits coordinate{-1e15, 1e15};  // m
inline constexpr Limits size{1e-12, 1e12};        // m
inline constexpr Limits rod_length{0.0, 1e12};    // m; 0 is told what to use instead
inline constexpr Limits mass{1e-30, 1e30};        // kg
inline constexpr Limits density{1e-30, 1e30};     // kg/m^2
inline constexpr Limits angle{-1e6, 1e6};         // rad: sin_cos keeps its accuracy
inline constexpr Limits degrees{-5e7, 5e7};
inline constexpr Limits rate{-1e12, 1e12};   // m/s, rad/s, m/s^2
inline constexpr Limits duration{0.0, 1e9};  // s
inline constexpr Limits friction{0.0, 1e6};
inline constexpr Limits restitution{0.0, 1.0};
inline constexpr Limits count{1.0, 200'000.0};
inline constexpr Limits bays{2.0, 50'000.0};
inline constexpr Limits seed{0.0, 9'007'199'254'740'992.0};  // 2^53: exact in every JSON reader
inline constexpr Limits name{1.0, 100.0};
inline constexpr Limits place{1.0, 103.0};  // a name and a part
inline constexpr Limits title{0.0, 200.0};
}  // namespace limits

/// Most bodies of a scene, and most planes (every cube is compared with every plane).
inline constexpr std::int64_t most_bodies = 200'000;
inline constexpr std::int64_t most_planes = 1'000;

/// Where an entry stands in the text.
struct Origin {
  const Value* table = nullptr;  ///< lives as long as the tree that was read
  std::string path;              ///< "cube[2]"
};

/// Side, or [width, height].
struct Size {
  Vec2 extent = Vec2::Ones();  ///< m
};

/// Axis-aligned rectangle [xmin, ymin, xmax, ymax].
struct Region {
  Vec2 low = Vec2::Zero();   ///< m
  Vec2 high = Vec2::Zero();  ///< m
};

/// Choices: what a text may say. `choices` has their names in order.
/// @{
enum class Bond { running, stack };
constexpr std::array<std::string_view, 2> choices(Bond /*type*/) { return {"running", "stack"}; }

enum class TrussKind { pratt, howe, warren };
constexpr std::array<std::string_view, 3> choices(TrussKind /*type*/) {
  return {"pratt", "howe", "warren"};
}

enum class Supports { roller, pins, none };
constexpr std::array<std::string_view, 3> choices(Supports /*type*/) {
  return {"roller", "pins", "none"};
}
/// @}

struct SurfaceEntry {
  std::optional<double> friction;
  std::optional<double> restitution;
};

/// Where something stands: at a point, or on a face of another body.
struct StandingEntry {
  std::optional<Vec2> point;  ///< centre of a body, middle of the lowest edge of a generated group
  std::optional<std::string> on;
  double offset = 0.0;  ///< m
};

struct TurnEntry {
  double angle = 0.0;  ///< rad
  std::optional<double> angle_deg;
};

/// What a cube and the cubes of a generator have in common.
struct BrickEntry {
  Origin origin;
  std::optional<std::string> name;
  Size size;
  double mass = 1.0;  ///< kg
  std::optional<double> density;
  SurfaceEntry surface;
  std::optional<Rgb> color;
};

struct PlaneEntry {
  Origin origin;
  std::optional<std::string> name;
  Vec2 point = Vec2::Zero();
  Vec2 normal = Vec2::UnitY();
  SurfaceEntry surface;
};

struct FixedEntry {
  Origin origin;
  std::optional<std::string> name;
  Size size;
  StandingEntry standing;
  TurnEntry turn;
  SurfaceEntry surface;
};

struct CubeEntry : BrickEntry {
  StandingEntry standing;
  TurnEntry turn;
  Vec2 velocity = Vec2::Zero();
  double spin = 0.0;
};

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

struct PairEntry {
  Origin origin;
  std::array<std::string, 2> bodies;
  SurfaceEntry surface;
};

struct PointEntry {
  Origin origin;
  std::optional<std::string> name;
  double mass = 1.0;
  Vec2 position = Vec2::Zero();
  Vec2 velocity = Vec2::Zero();
};

/// A place as it is written: a body's name with or without a part, a body and a place in its frame,
/// or a place of the world.
struct PlaceEntry {
  std::string name;        ///< "a" or "a.ne"; empty: a place of the world
  bool in_frame = false;   ///< `at` is in the frame of the body `name`
  Vec2 at = Vec2::Zero();  ///< m
};

struct RodEntry {
  Origin origin;
  std::optional<std::string> name;
  PlaceEntry from;
  PlaceEntry to;
  std::optional<double> length;
};

struct PinEntry {
  Origin origin;
  std::optional<std::string> name;
  PlaceEntry from;
  PlaceEntry to;
  bool collide = false;
};

/// Point masses joined by rods, or cubes joined by rods or pins.
struct ChainEntry : BrickEntry {
  std::optional<Size> link;  ///< of a cube; none: the links are points
  std::int64_t count = 0;
  PlaceEntry from;
  PlaceEntry to;
  std::optional<double> length;  ///< m
  bool loose = false;
};

struct TrussEntry {
  Origin origin;
  std::optional<std::string> name;
  std::int64_t count = 0;
  Vec2 from = Vec2::Zero();  ///< m, ends of the lower chord
  Vec2 to = Vec2::Zero();
  double height = 1.0;  ///< m
  TrussKind kind = TrussKind::pratt;
  Supports supports = Supports::roller;
  double mass = 1.0;  ///< kg, of a joint
};

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
void describe(Keys& keys, Material& material) {
  keys.value("friction", material.friction, limits::friction, "Coulomb coefficient");
  keys.value("restitution", material.restitution, limits::restitution,
             "Newton coefficient: 0 does not bounce");
}

template <class Keys>
void describe_surface(Keys& keys, SurfaceEntry& surface) {
  keys.value("friction", surface.friction, limits::friction,
             "Coulomb coefficient; default from [material]. A pair takes the geometric mean of its "
             "two values");
  keys.value("restitution", surface.restitution, limits::restitution,
             "Newton coefficient; default from [material]. A pair takes the geometric mean of its "
             "two values");
}

template <class Keys>
void describe_standing(Keys& keys,
                       StandingEntry& standing,
                       std::string_view point_key,
                       std::string_view point_doc) {
  keys.value(point_key, standing.point, limits::coordinate, point_doc);
  keys.value("on", standing.on, limits::name,
             "Instead of a point: name of the body on whose top face (or plane) it stands, "
             "touching exactly and "
             "turned with the face");
  keys.value("offset", standing.offset, limits::coordinate,
             "m, with `on`: how far the middle is shifted along the face, from the middle of the "
             "face or the "
             "plane's point");
  keys.exactly_one({point_key, "on"});
  keys.needs("offset", "on");
}

template <class Keys>
void describe_turn(Keys& keys, TurnEntry& turn) {
  keys.value("angle", turn.angle, limits::angle, "rad, counter-clockwise");
  keys.value("angle_deg", turn.angle_deg, limits::degrees, "Degrees, instead of angle");
  keys.at_most_one({"angle", "angle_deg", "on"});
}

template <class Keys>
void describe_brick(Keys& keys, BrickEntry& brick, std::string_view name_doc) {
  keys.value("name", brick.name, limits::name, name_doc);
  keys.value("size", brick.size, limits::size, "m: side, or [width, height]");
  keys.value("mass", brick.mass, limits::mass, "kg, of one cube");
  keys.value("density", brick.density, limits::density, "kg/m^2, instead of mass");
  keys.at_most_one({"mass", "density"});
  describe_surface(keys, brick.surface);
  keys.value("color", brick.color, "\"#rrggbb\" or a name of the Okabe-Ito palette");
}

template <class Keys>
void describe(Keys& keys, PlaneEntry& plane) {
  keys.value("name", plane.name, limits::name, "Default plane1, plane2, ...");
  keys.value("point", plane.point, limits::coordinate, "m, a point of the boundary");
  keys.value("normal", plane.normal, limits::coordinate,
             "Direction out of the solid; any length but zero");
  describe_surface(keys, plane.surface);
}

template <class Keys>
void describe(Keys& keys, FixedEntry& fixed) {
  keys.value("name", fixed.name, limits::name, "Default fixed1, fixed2, ...");
  keys.value("size", fixed.size, limits::size, "m: side, or [width, height]");
  describe_standing(keys, fixed.standing, "position", "m, centre");
  describe_turn(keys, fixed.turn);
  describe_surface(keys, fixed.surface);
}

template <class Keys>
void describe(Keys& keys, CubeEntry& cube) {
  describe_brick(keys, cube, "Default cube1, cube2, ...");
  describe_standing(keys, cube.standing, "position", "m, centre");
  describe_turn(keys, cube.turn);
  keys.value("velocity", cube.velocity, limits::rate, "m/s, of the centre");
  keys.value("spin", cube.spin, limits::rate, "rad/s, counter-clockwise");
}

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

template <class Keys>
void describe(Keys& keys, PairEntry& pair) {
  keys.required("bodies", pair.bodies, limits::name, "Names of the two bodies");
  keys.value("friction", pair.surface.friction, limits::friction,
             "Coulomb coefficient between the two");
  keys.value("restitution", pair.surface.restitution, limits::restitution,
             "Newton coefficient between the two");
  keys.at_least_one({"friction", "restitution"});
}

template <class Keys>
void describe(Keys& keys, PointEntry& point) {
  keys.value("name", point.name, limits::name, "Default point1, point2, ...");
  keys.value("mass", point.mass, limits::mass, "kg");
  keys.required("position", point.position, limits::coordinate, "m");
  keys.value("velocity", point.velocity, limits::rate, "m/s");
}

inline constexpr std::string_view place_doc =
    "A place: \"a\" (centre of a body, or a point), \"a.ne\" (corner: sw se ne nw), \"a.n\" "
    "(middle "
    "of a side: s e n w), { body = \"a\", at = [x, y] } in the frame of the body, or [x, y] fixed "
    "in "
    "the world";

template <class Keys>
void describe(Keys& keys, RodEntry& rod) {
  keys.value("name", rod.name, limits::name, "Default rod1, rod2, ...");
  keys.required("from", rod.from, limits::coordinate, place_doc);
  keys.required("to", rod.to, limits::coordinate, place_doc);
  keys.value(
      "length", rod.length, limits::rod_length,
      "m; default the distance of the two places at the start, which it must be in any case");
}

template <class Keys>
void describe(Keys& keys, PinEntry& pin) {
  keys.value("name", pin.name, limits::name, "Default pin1, pin2, ...");
  keys.required("from", pin.from, limits::coordinate, place_doc);
  keys.required("to", pin.to, limits::coordinate, place_doc);
  keys.value("collide", pin.collide, "Whether the two bodies may touch each other");
}

template <class Keys>
void describe(Keys& keys, ChainEntry& chain) {
  keys.value("name", chain.name, limits::name,
             "Default chain1, chain2, ...; its links are chain1_1, chain1_2, ... from `from` on, "
             "its rods chain1_rod1, ..., its pins chain1_pin1, ...");
  keys.required("count", chain.count, limits::count, "Number of links");
  keys.required("from", chain.from, limits::coordinate, place_doc);
  keys.required("to", chain.to, limits::coordinate, place_doc);
  keys.value("length", chain.length, limits::size,
             "m, of the whole chain; default the distance of the two places, more sags along an "
             "arc");
  keys.value("loose", chain.loose,
             "Whether the end of the chain hangs free: the last link ends at `to`, held by "
             "nothing");
  keys.value("size", chain.link, limits::size,
             "m: the links are cubes of this side, or [length along the chain, thickness], joined "
             "by rods over what is left of the length, by pins where nothing is; none: the links "
             "are point masses joined by rods");
  keys.value("mass", chain.mass, limits::mass, "kg, of one link");
  keys.value("density", chain.density, limits::density, "kg/m^2, instead of mass");
  keys.at_most_one({"mass", "density"});
  keys.needs("density", "size");
  describe_surface(keys, chain.surface);
  keys.needs("friction", "size");
  keys.needs("restitution", "size");
  keys.value("color", chain.color, "\"#rrggbb\" or a name of the Okabe-Ito palette");
  keys.needs("color", "size");
}

template <class Keys>
void describe(Keys& keys, TrussEntry& truss) {
  keys.value("name", truss.name, limits::name,
             "Default truss1, truss2, ...; its joints are points: truss1_b0, truss1_b1, ... of the "
             "lower chord, truss1_t1, ... of the upper; its rods truss1_bottom1, truss1_top1, "
             "truss1_post1, truss1_diagonal1, ..., its supports truss1_left and truss1_right");
  keys.required("count", truss.count, limits::bays, "Number of bays");
  keys.required("from", truss.from, limits::coordinate, "m, left end of the lower chord");
  keys.required("to", truss.to, limits::coordinate, "m, right end of the lower chord");
  keys.value("height", truss.height, limits::size, "m, of the upper chord over the lower");
  keys.value("kind", truss.kind,
             "pratt: posts, diagonals that fall towards the middle; howe: posts, diagonals that "
             "rise towards the middle; warren: triangles without posts");
  keys.value("supports", truss.supports,
             "roller: a pin at the left end and a rod of the truss's height under the right end; "
             "pins: at both ends; none: it is free");
  keys.value("mass", truss.mass, limits::mass, "kg, of one joint; rods have no mass");
}

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
