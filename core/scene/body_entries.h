/// Tables of a scene text that are one body, or two that touch.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/entry_parts.h"

namespace wuerfel {

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

struct PairEntry {
  Origin origin;
  std::array<std::string, 2> bodies;
  SurfaceEntry surface;
};

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

template <class Keys>
void describe(Keys& keys, PairEntry& pair) {
  keys.required("bodies", pair.bodies, limits::name, "Names of the two bodies");
  keys.value("friction", pair.surface.friction, limits::friction,
             "Coulomb coefficient between the two");
  keys.value("restitution", pair.surface.restitution, limits::restitution,
             "Newton coefficient between the two");
  keys.at_least_one({"friction", "restitution"});
}

}  // namespace wuerfel
