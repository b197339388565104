/// What tables of a scene text have in common: limits, sizes, where something stands, surfaces.
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

}  // namespace wuerfel
