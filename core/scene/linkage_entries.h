/// Tables of a scene text that join bodies: point masses, rods, pins, chains and trusses.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/entry_parts.h"

namespace wuerfel {

/// What a text may say; `choices` has the names in order.
/// @{
enum class TrussKind { pratt, howe, warren };
constexpr std::array<std::string_view, 3> choices(TrussKind /*type*/) {
  return {"pratt", "howe", "warren"};
}

enum class Supports { roller, pins, none };
constexpr std::array<std::string_view, 3> choices(Supports /*type*/) {
  return {"roller", "pins", "none"};
}
/// @}

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

}  // namespace wuerfel
