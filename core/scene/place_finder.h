/// Places of rods, pins and chains: what they name, and where that is at the start.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/scene/groups.h"

namespace wuerfel {

struct BodyPart;

/// A place, resolved.
struct FoundPlace {
  ScenePlace place;
  std::optional<BodyRef> body;  ///< none: fixed in the world
  Vec2 world = Vec2::Zero();    ///< m, at the start
  double scale = 1.0;           ///< m, by which tolerances are measured: the smaller side of a box
  [[nodiscard]] bool moves() const { return body && body->kind != BodyKind::fixed; }
};

class PlaceFinder {
 public:
  PlaceFinder(const Scene& scene, const BodyNames& names, const SceneSource& source)
      : scene_(scene), names_(names), source_(source) {}

  /// Throws SceneError at `key` of `origin` where an entry names no body or no part of one, or both a body
  /// ("a.n") and a part of another.
  [[nodiscard]] FoundPlace find(const PlaceEntry& entry,
                                const Origin& origin,
                                std::string_view key) const;

 private:
  [[nodiscard]] Vec2 half_size(const BodyRef& body) const;
  const BodyPart* split_part(std::string& name, const Origin& origin, std::string_view key) const;

  const Scene& scene_;
  const BodyNames& names_;
  const SceneSource& source_;
};

}  // namespace wuerfel
