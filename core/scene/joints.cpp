#include "core/scene/joints.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "core/geometry/box.h"
#include "core/scene/suggestion.h"

namespace wuerfel {
namespace {

/// A part of a body, in half widths and half heights from its centre.
struct Part {
  std::string_view name;
  Vec2 at;
};

const std::array<Part, 8> parts = {{{"sw", {-1.0, -1.0}},
                                    {"se", {1.0, -1.0}},
                                    {"ne", {1.0, 1.0}},
                                    {"nw", {-1.0, 1.0}},
                                    {"s", {0.0, -1.0}},
                                    {"e", {1.0, 0.0}},
                                    {"n", {0.0, 1.0}},
                                    {"w", {-1.0, 0.0}}}};

/// An end of a joint.
struct End {
  ScenePlace place;
  std::optional<BodyRef> body;  ///< none: fixed in the world
  Vec2 world = Vec2::Zero();    ///< m, at the start
  double scale = 1.0;           ///< m, by which tolerances are measured: the smaller side of a box
  [[nodiscard]] bool moves() const { return body && body->kind != BodyKind::fixed; }
};

class JointReader {
 public:
  JointReader(Scene& scene, const BodyNames& names, const SceneSource& source)
      : scene_(scene), names_(names), source_(source) {}

  void add(const RodEntry& entry) {
    SceneRod rod;
    rod.name = entry.name.value_or(fmt::format("rod{}", scene_.rods.size() + 1));
    const auto [from, to] = ends_of(entry, rod.name);
    const double distance = (from.world - to.world).norm();
    if (distance <= touching_tolerance * std::min(from.scale, to.scale)) {
      source_.fail(
          entry.origin.table->place, entry.origin.path,
          fmt::format("\"{}\" has no length, for its places coincide; use a [[pin]]", rod.name));
    }
    // What the places say must be as fit for reading as what was written.
    if (distance < limits::size.min || distance > limits::size.max) {
      source_.fail(entry.origin.table->place, entry.origin.path,
                   fmt::format("\"{}\" would be {} m long, out of range", rod.name, distance));
    }
    rod.length = entry.length.value_or(distance);
    if (std::abs(distance - rod.length) > touching_tolerance * rod.length) {
      source_.fail(
          place_of(entry.origin, "length"), entry.origin.path + ".length",
          fmt::format("must be the distance of the two places at the start, {} m; it is {} m",
                      distance, rod.length));
    }
    rod.from = from.place;
    rod.to = to.place;
    scene_.rods.push_back(std::move(rod));
  }

  void add(const PinEntry& entry) {
    ScenePin pin;
    pin.name = entry.name.value_or(fmt::format("pin{}", scene_.pins.size() + 1));
    const auto [from, to] = ends_of(entry, pin.name);
    const double distance = (from.world - to.world).norm();
    if (distance > touching_tolerance * std::min(from.scale, to.scale)) {
      source_.fail(
          entry.origin.table->place, entry.origin.path,
          fmt::format(
              "the places of \"{}\" must coincide; they are {:.6g} m apart: [{:.6g}, {:.6g}] and "
              "[{:.6g}, {:.6g}]",
              pin.name, distance, from.world.x(), from.world.y(), to.world.x(), to.world.y()));
    }
    pin.from = from.place;
    pin.to = to.place;
    pin.collide = entry.collide;
    scene_.pins.push_back(std::move(pin));
  }

 private:
  template <class Entry>
  std::pair<End, End> ends_of(const Entry& entry, const std::string& name) {
    if (!taken_.insert(name).second) {
      source_.fail(place_of(entry.origin, "name"), entry.origin.path,
                   fmt::format("the name \"{}\" is taken by another rod or pin", name));
    }
    const End from = end_of(entry.from, entry.origin, "from");
    const End to = end_of(entry.to, entry.origin, "to");
    const auto fail = [&](std::string_view why) {
      source_.fail(entry.origin.table->place, entry.origin.path,
                   fmt::format("\"{}\" {}", name, why));
    };
    if (!from.moves() && !to.moves()) fail("joins two places that cannot move");
    if (from.body && to.body && *from.body == *to.body)
      fail("joins two places of one body, which keep their distance anyway");
    return {from, to};
  }

  [[noreturn]] void fail_at(const Origin& origin,
                            std::string_view key,
                            const std::string& message) const {
    source_.fail(place_of(origin, key), fmt::format("{}.{}", origin.path, key), message);
  }

  [[nodiscard]] Vec2 half_size(const BodyRef& body) const {
    if (body.kind == BodyKind::cube) return 0.5 * scene_.cubes[body.index].size;
    return body.kind == BodyKind::fixed ? Vec2(0.5 * scene_.fixed[body.index].size) : Vec2::Zero();
  }

  [[nodiscard]] End end_of(const PlaceEntry& entry,
                           const Origin& origin,
                           std::string_view key) const {
    End end;
    if (entry.name.empty()) {
      end.place.at = end.world = entry.at;
      return end;
    }
    std::string name = entry.name;
    const Part* part = entry.in_frame ? nullptr : split_part(name, origin, key);
    end.body = find_body(names_, name, origin, key, source_);
    if (end.body->kind == BodyKind::plane) {
      fail_at(origin, key,
              fmt::format("\"{}\" is a plane; name a place [x, y] of the world instead", name));
    }
    const bool elsewhere = part != nullptr || !entry.at.isZero(0.0);
    if (end.body->kind == BodyKind::point && elsewhere)
      fail_at(origin, key, fmt::format("\"{}\" is a point, which has no parts", name));
    const Vec2 half = half_size(*end.body);
    if (end.body->kind != BodyKind::point) end.scale = 2.0 * half.minCoeff();
    end.place = {name, part != nullptr ? Vec2(part->at.cwiseProduct(half)) : entry.at};
    end.world = place_in_world(scene_, *end.body, end.place.at);
    return end;
  }

  /// Takes the part off a name where there is no body of the whole name.
  const Part* split_part(std::string& name, const Origin& origin, std::string_view key) const {
    const std::size_t dot = name.rfind('.');
    if (names_.contains(name) || dot == std::string::npos) return nullptr;
    const std::string body = name.substr(0, dot);
    if (!names_.contains(body)) return nullptr;
    const std::string wanted = name.substr(dot + 1);
    name = body;
    const auto found = std::ranges::find(parts, wanted, &Part::name);
    if (found != parts.end()) return &*found;
    std::vector<std::string_view> known;
    known.reserve(std::size(parts));
    for (const Part& part : parts)
      known.push_back(part.name);
    fail_at(origin, key,
            fmt::format("\"{}\" has no part \"{}\"{}", body, wanted, suggestion(wanted, known)));
  }

  Scene& scene_;
  const BodyNames& names_;
  const SceneSource& source_;
  std::set<std::string> taken_;
};

Vec2 placed(const Vec2& position, double angle, const Vec2& at) {
  const Vec2 axis = make_box(position, angle, Vec2::Zero()).axis;
  return position + at.x() * axis + at.y() * perp(axis);
}

}  // namespace

Vec2 place_in_world(const Scene& scene, const BodyRef& body, const Vec2& at) {
  if (body.kind == BodyKind::point) return scene.points[body.index].position;
  if (body.kind == BodyKind::cube) {
    const SceneCube& cube = scene.cubes[body.index];
    return placed(cube.position, cube.angle, at);
  }
  const SceneFixed& fixed = scene.fixed[body.index];
  return placed(fixed.position, fixed.angle, at);
}

void add_joints(Scene& scene,
                const SceneEntries& entries,
                const BodyNames& names,
                const SceneSource& source) {
  JointReader reader(scene, names, source);
  for (const RodEntry& rod : entries.rods)
    reader.add(rod);
  for (const PinEntry& pin : entries.pins)
    reader.add(pin);
}

}  // namespace wuerfel
