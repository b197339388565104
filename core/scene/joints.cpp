#include "core/scene/joints.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "core/geometry/box.h"
#include "core/scene/place_finder.h"

namespace wuerfel {
namespace {

class JointReader {
 public:
  JointReader(Scene& scene, const BodyNames& names, const SceneSource& source)
      : scene_(scene), finder_(scene, names, source), source_(source) {}

  void add(const RodEntry& entry) {
    SceneRod rod;
    rod.name = entry.name.value_or(fmt::format("rod{}", scene_.rods.size() + 1));
    const auto [from, to] = ends_of(entry, rod.name);
    const double distance = (from.world - to.world).norm();
    if (distance <= touching_tolerance * std::min(from.scale, to.scale)) {
      fail_at(
          source_, entry.origin,
          fmt::format("\"{}\" has no length, for its places coincide; use a [[pin]]", rod.name));
    }
    // What the places say must be as fit for reading as what was written.
    if (distance < limits::size.min || distance > limits::size.max) {
      fail_at(source_, entry.origin,
              fmt::format("\"{}\" would be {} m long, out of range", rod.name, distance));
    }
    rod.length = entry.length.value_or(distance);
    if (std::abs(distance - rod.length) > touching_tolerance * rod.length) {
      fail_at(source_, entry.origin, "length",
              fmt::format(
                  "must be the distance of the two places at the start, {} m; it is {} m{}",
                  distance, rod.length,
                  rod.length == 0.0 ? ". Places that stay together are joined by a [[pin]]" : ""));
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
      fail_at(
          source_, entry.origin,
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
  std::pair<FoundPlace, FoundPlace> ends_of(const Entry& entry, const std::string& name) {
    if (!taken_.insert(name).second) {
      source_.fail(place_of(entry.origin, "name"), entry.origin.path,
                   fmt::format("the name \"{}\" is taken by another rod or pin", name));
    }
    const FoundPlace from = finder_.find(entry.from, entry.origin, "from");
    const FoundPlace to = finder_.find(entry.to, entry.origin, "to");
    const auto fail = [&](std::string_view why) {
      fail_at(source_, entry.origin, fmt::format("\"{}\" {}", name, why));
    };
    if (!from.moves() && !to.moves()) fail("joins two places that cannot move");
    if (from.body && to.body && *from.body == *to.body)
      fail("joins two places of one body, which keep their distance anyway");
    return {from, to};
  }

  Scene& scene_;
  PlaceFinder finder_;
  const SceneSource& source_;
  std::set<std::string> taken_;
};

}  // namespace

void add_joints(Scene& scene,
                const JointEntries& entries,
                const BodyNames& names,
                const SceneSource& source) {
  JointReader reader(scene, names, source);
  for (const RodEntry& rod : entries.rods)
    reader.add(rod);
  for (const PinEntry& pin : entries.pins)
    reader.add(pin);
}

}  // namespace wuerfel
