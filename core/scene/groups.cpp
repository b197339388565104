#include "core/scene/groups.h"

#include <utility>

#include <fmt/format.h>

#include "core/scene/suggestion.h"

namespace wuerfel {
namespace {

void add_names(BodyNames& names,
               const Scene& scene,
               const Groups& groups,
               const SceneSource& source,
               BodyKind kind,
               std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const BodyRef body{kind, static_cast<int>(i)};
    const std::string& name = body_name(scene, body);
    const auto [other, is_new] = names.emplace(name, body);
    if (is_new) continue;
    const Group& here = groups.of(body);
    const Group& there = groups.of(other->second);
    source.fail(place_of(*here.origin, "name"), here.origin->path,
                fmt::format("the name \"{}\" is taken by {}", name, there.origin->path));
  }
}

}  // namespace

void Groups::add(Group group) {
  auto& owner = owner_[static_cast<std::size_t>(group.kind)];
  owner.insert(owner.end(), group.count, static_cast<int>(groups_.size()));
  groups_.push_back(std::move(group));
}

BodyNames collect_names(const Scene& scene, const Groups& groups, const SceneSource& source) {
  BodyNames names;
  add_names(names, scene, groups, source, BodyKind::plane, scene.planes.size());
  add_names(names, scene, groups, source, BodyKind::fixed, scene.fixed.size());
  add_names(names, scene, groups, source, BodyKind::cube, scene.cubes.size());
  add_names(names, scene, groups, source, BodyKind::point, scene.points.size());
  return names;
}

BodyRef find_body(const BodyNames& names,
                  const std::string& name,
                  const Origin& origin,
                  std::string_view key,
                  const SceneSource& source) {
  const auto found = names.find(name);
  if (found != names.end()) return found->second;
  fail_at(source, origin, key,
          fmt::format("there is no body \"{}\"{}", name,
                      suggestion(name, names, &BodyNames::value_type::first)));
}

Place place_of(const Origin& origin, std::string_view key) {
  const Member* member = find_member(std::get<Value::Table>(origin.table->data), key);
  return member == nullptr ? origin.table->place : member->value.place;
}

void fail_at(const SceneSource& source,
             const Origin& origin,
             std::string_view key,
             const std::string& message) {
  source.fail(place_of(origin, key), fmt::format("{}.{}", origin.path, key), message);
}

void fail_at(const SceneSource& source, const Origin& origin, const std::string& message) {
  source.fail(origin.table->place, origin.path, message);
}

}  // namespace wuerfel
