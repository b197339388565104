#include "core/scene/place_finder.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

#include "core/geometry/box.h"
#include "core/scene/suggestion.h"

namespace wuerfel {

/// A part of a body, in half widths and half heights from its centre.
struct BodyPart {
  std::string_view name;
  Vec2 at;
};

namespace {

const std::array<BodyPart, 8> parts = {{{"sw", {-1.0, -1.0}},
                                        {"se", {1.0, -1.0}},
                                        {"ne", {1.0, 1.0}},
                                        {"nw", {-1.0, 1.0}},
                                        {"s", {0.0, -1.0}},
                                        {"e", {1.0, 0.0}},
                                        {"n", {0.0, 1.0}},
                                        {"w", {-1.0, 0.0}}}};

/// Corners and sides that a place may name.
bool has_parts(const BodyRef& body) {
  return body.kind == BodyKind::cube || body.kind == BodyKind::fixed;
}

Vec2 placed(const Vec2& position, double angle, const Vec2& at) {
  const Vec2 axis = make_box(position, angle, Vec2::Zero()).axis;
  return position + at.x() * axis + at.y() * perp(axis);
}

/// Where a place is at the start, m.
Vec2 place_in_world(const Scene& scene, const BodyRef& body, const Vec2& at) {
  if (body.kind == BodyKind::point) return scene.points[body.index].position;
  if (body.kind == BodyKind::cube) {
    const SceneCube& cube = scene.cubes[body.index];
    return placed(cube.position, cube.angle, at);
  }
  const SceneFixed& fixed = scene.fixed[body.index];
  return placed(fixed.position, fixed.angle, at);
}

}  // namespace

Vec2 PlaceFinder::half_size(const BodyRef& body) const {
  if (body.kind == BodyKind::cube) return 0.5 * scene_.cubes[body.index].size;
  return body.kind == BodyKind::fixed ? Vec2(0.5 * scene_.fixed[body.index].size) : Vec2::Zero();
}

FoundPlace PlaceFinder::find(const PlaceEntry& entry,
                             const Origin& origin,
                             std::string_view key) const {
  FoundPlace end;
  if (entry.name.empty()) {
    end.place.at = end.world = entry.at;
    return end;
  }
  std::string name = entry.name;
  const BodyPart* part = entry.in_frame ? nullptr : split_part(name, origin, key);
  end.body = find_body(names_, name, origin, key, source_);
  if (end.body->kind == BodyKind::plane) {
    fail_at(source_, origin, key,
            fmt::format("\"{}\" is a plane; name a place [x, y] of the world instead", name));
  }
  const bool elsewhere = part != nullptr || !entry.at.isZero(0.0);
  if (end.body->kind == BodyKind::point && elsewhere)
    fail_at(source_, origin, key, fmt::format("\"{}\" is a point, which has no parts", name));
  const Vec2 half = half_size(*end.body);
  if (end.body->kind != BodyKind::point) end.scale = 2.0 * half.minCoeff();
  end.place = {name, part != nullptr ? Vec2(part->at.cwiseProduct(half)) : entry.at};
  end.world = place_in_world(scene_, *end.body, end.place.at);
  return end;
}

/// Takes the part off a name where there is no body of the whole name. What may be meant either way is refused.
const BodyPart* PlaceFinder::split_part(std::string& name,
                                        const Origin& origin,
                                        std::string_view key) const {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos) return nullptr;
  const std::string body = name.substr(0, dot);
  const auto owner = names_.find(body);
  const std::string wanted = name.substr(dot + 1);
  const auto found = std::ranges::find(parts, wanted, &BodyPart::name);
  if (names_.contains(name)) {
    if (owner == names_.end() || found == parts.end() || !has_parts(owner->second)) return nullptr;
    const Vec2 at = found->at.cwiseProduct(half_size(owner->second));
    fail_at(source_, origin, key,
            fmt::format("\"{0}\" is a body of that name and a part of \"{1}\" as well; write {{ "
                        "body = \"{0}\", at = [0, 0] }} "
                        "or {{ body = \"{1}\", at = [{2}, {3}] }}",
                        name, body, at.x(), at.y()));
  }
  if (owner == names_.end()) return nullptr;
  name = body;
  if (found != parts.end()) return &*found;
  fail_at(source_, origin, key,
          fmt::format("\"{}\" has no part \"{}\"{}", body, wanted,
                      suggestion(wanted, parts, &BodyPart::name)));
}

}  // namespace wuerfel
