#include "core/scene/scene_builder.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "core/scene/chain.h"
#include "core/scene/groups.h"
#include "core/scene/joints.h"
#include "core/scene/layout.h"
#include "core/scene/overlap.h"
#include "core/scene/pile.h"
#include "core/scene/placement.h"
#include "core/scene/scene_checks.h"
#include "core/scene/truss.h"

namespace wuerfel {
namespace {

/// `direction` with length 1. What has that length already but for rounding is left alone, so that
/// a scene that was written out comes back with the same bits.
Vec2 unit(const Vec2& direction) {
  constexpr double rounding = 8.0 * std::numeric_limits<double>::epsilon();
  if (std::abs(direction.squaredNorm() - 1.0) <= rounding) return direction;
  const Vec2 scaled = direction / direction.cwiseAbs().maxCoeff();
  return scaled / scaled.norm();
}

/// A whole number of half turns in degrees gives the double next to that many pi.
double angle_of(const TurnEntry& turn) {
  return turn.angle_deg ? *turn.angle_deg / 180.0 * std::numbers::pi : turn.angle;
}

class SceneBuilder {
 public:
  SceneBuilder(const SceneEntries& entries, const SceneSource& source)
      : entries_(entries), source_(source) {}

  Scene build() {
    check_counts(entries_, source_);
    take_head();
    add_planes();
    add_fixed();
    add_cubes();
    add_generators();
    add_points();
    add_linkages();
    const BodyNames names = collect_names(scene_, groups_, source_);
    place_groups(scene_, groups_, names, source_);
    JointEntries joints{entries_.rods, entries_.pins};
    lay_chains({scene_, groups_, names, source_}, entries_.chains, joints);
    for (int i = 0; i < static_cast<int>(entries_.trusses.size()); ++i)
      join_truss(entries_.trusses[i], truss_name(entries_.trusses, i), joints);
    scatter_piles(scene_, entries_.piles, source_);
    add_pairs(names);
    add_joints(scene_, joints, names, source_);
    check_ranges(scene_, groups_, source_);
    check_overlap(scene_, groups_, source_);
    return std::move(scene_);
  }

 private:
  void take_head() {
    scene_.title = entries_.title;
    scene_.gravity = entries_.gravity;
    scene_.duration = entries_.duration;
    scene_.material = entries_.material;
  }

  [[nodiscard]] Material material_of(const SurfaceEntry& surface) const {
    return {surface.friction.value_or(scene_.material.friction),
            surface.restitution.value_or(scene_.material.restitution)};
  }

  void add_planes() {
    for (const PlaneEntry& entry : entries_.planes) {
      if (entry.normal.isZero(0.0)) fail_at(source_, entry.origin, "normal", "must not be zero");
      const auto index = static_cast<int>(scene_.planes.size());
      ScenePlane plane;
      plane.name = entry.name.value_or(fmt::format("plane{}", index + 1));
      plane.point = entry.point;
      plane.normal = unit(entry.normal);
      plane.material = material_of(entry.surface);
      groups_.add(
          {BodyKind::plane, index, 1, PlacedBy::itself, &entry.origin, nullptr, plane.name});
      scene_.planes.push_back(std::move(plane));
    }
  }

  /// Centre within the frame: a body that stands on something has its frame in the middle of its
  /// lowest edge.
  static Vec2 local_center(const StandingEntry& standing, const Size& size) {
    return standing.on ? Vec2(0.0, 0.5 * size.extent.y()) : Vec2(0.0, 0.0);
  }

  void add_fixed() {
    for (const FixedEntry& entry : entries_.fixed) {
      const auto index = static_cast<int>(scene_.fixed.size());
      SceneFixed fixed;
      fixed.name = entry.name.value_or(fmt::format("fixed{}", index + 1));
      fixed.size = entry.size.extent;
      fixed.position = local_center(entry.standing, entry.size);
      fixed.angle = angle_of(entry.turn);
      fixed.material = material_of(entry.surface);
      groups_.add({BodyKind::fixed, index, 1, PlacedBy::standing, &entry.origin, &entry.standing,
                   fixed.name});
      scene_.fixed.push_back(std::move(fixed));
    }
  }

  [[nodiscard]] SceneCube cube_of(const BrickEntry& entry, const Brick& brick) const {
    SceneCube cube;
    cube.size = brick.size;
    cube.mass =
        entry.density ? *entry.density * brick.size.x() * brick.size.y() : entry.mass * brick.share;
    cube.position = brick.center;
    cube.material = material_of(entry.surface);
    cube.color = entry.color;
    return cube;
  }

  void add_cubes() {
    for (const CubeEntry& entry : entries_.cubes) {
      const auto index = static_cast<int>(scene_.cubes.size());
      SceneCube cube =
          cube_of(entry, {local_center(entry.standing, entry.size), entry.size.extent, 1.0});
      cube.name = entry.name.value_or(fmt::format("cube{}", index + 1));
      cube.angle = angle_of(entry.turn);
      cube.velocity = entry.velocity;
      cube.spin = entry.spin;
      groups_.add({BodyKind::cube, index, 1, PlacedBy::standing, &entry.origin, &entry.standing,
                   cube.name});
      scene_.cubes.push_back(std::move(cube));
    }
  }

  void add_generated(const BrickEntry& entry,
                     const std::vector<Brick>& bricks,
                     PlacedBy placed_by,
                     const StandingEntry* standing,
                     const std::string& default_name) {
    Group group;
    group.first = static_cast<int>(scene_.cubes.size());
    group.count = static_cast<int>(bricks.size());
    group.placed_by = placed_by;
    group.origin = &entry.origin;
    group.standing = standing;
    group.name = entry.name.value_or(default_name);
    int number = 0;
    for (const Brick& brick : bricks) {
      SceneCube cube = cube_of(entry, brick);
      cube.name = fmt::format("{}_{}", group.name, ++number);
      scene_.cubes.push_back(std::move(cube));
    }
    groups_.add(std::move(group));
  }

  /// Cubes that get their places later.
  static std::vector<Brick> alike(std::int64_t count, const Vec2& size) {
    return std::vector<Brick>(count, {Vec2::Zero(), size, 1.0});
  }

  void add_generators() {
    int number = 0;
    for (const TowerEntry& tower : entries_.towers) {
      add_generated(tower, tower_layout(tower), PlacedBy::standing, &tower.standing,
                    fmt::format("tower{}", ++number));
    }
    number = 0;
    for (const WallEntry& wall : entries_.walls) {
      add_generated(wall, wall_layout(wall), PlacedBy::standing, &wall.standing,
                    fmt::format("wall{}", ++number));
    }
    number = 0;
    for (const PyramidEntry& pyramid : entries_.pyramids) {
      add_generated(pyramid, pyramid_layout(pyramid), PlacedBy::standing, &pyramid.standing,
                    fmt::format("pyramid{}", ++number));
    }
    for (int i = 0; i < static_cast<int>(entries_.chains.size()); ++i) {
      const ChainEntry& chain = entries_.chains[i];
      if (!chain.link) continue;
      add_generated(chain, alike(chain.count, chain.link->extent), PlacedBy::chain, nullptr,
                    chain_name(entries_.chains, i));
    }
    number = 0;
    for (const PileEntry& pile : entries_.piles) {
      add_generated(pile, alike(pile.count, pile.size.extent), PlacedBy::pile, nullptr,
                    fmt::format("pile{}", ++number));
    }
  }

  void add_points() {
    for (const PointEntry& entry : entries_.points) {
      const auto index = static_cast<int>(scene_.points.size());
      ScenePoint point{entry.name.value_or(fmt::format("point{}", index + 1)), entry.mass,
                       entry.position, entry.velocity, scene_.material};
      groups_.add(
          {BodyKind::point, index, 1, PlacedBy::itself, &entry.origin, nullptr, point.name});
      scene_.points.push_back(std::move(point));
    }
  }

  void add_group(const Origin& origin,
                 const std::string& name,
                 PlacedBy placed_by,
                 std::vector<ScenePoint> points) {
    const auto first = static_cast<int>(scene_.points.size());
    const auto count = static_cast<int>(points.size());
    groups_.add({BodyKind::point, first, count, placed_by, &origin, nullptr, name});
    std::ranges::move(points, std::back_inserter(scene_.points));
  }

  void add_linkages() {
    for (int i = 0; i < static_cast<int>(entries_.chains.size()); ++i) {
      const ChainEntry& chain = entries_.chains[i];
      const std::string name = chain_name(entries_.chains, i);
      if (!chain.link)
        add_group(chain.origin, name, PlacedBy::chain, chain_points(chain, name, scene_.material));
    }
    for (int i = 0; i < static_cast<int>(entries_.trusses.size()); ++i) {
      const TrussEntry& truss = entries_.trusses[i];
      const std::string name = truss_name(entries_.trusses, i);
      add_group(truss.origin, name, PlacedBy::itself,
                truss_points(truss, name, scene_.material, source_));
    }
  }

  void add_pairs(const BodyNames& names) {
    std::set<std::pair<BodyRef, BodyRef>> seen;
    for (const PairEntry& entry : entries_.pairs) {
      const BodyRef a = find_body(names, entry.bodies[0], entry.origin, "bodies", source_);
      const BodyRef b = find_body(names, entry.bodies[1], entry.origin, "bodies", source_);
      const auto fail = [&](const std::string& message) {
        fail_at(source_, entry.origin, "bodies", message);
      };
      if (a == b) fail("must be two different bodies");
      if (!seen.insert(std::minmax(a, b)).second) {
        fail(fmt::format("the pair \"{}\", \"{}\" is given twice", entry.bodies[0],
                         entry.bodies[1]));
      }
      scene_.pairs.push_back({entry.bodies, entry.surface.friction, entry.surface.restitution});
    }
  }

  const SceneEntries& entries_;
  const SceneSource& source_;
  Scene scene_;
  Groups groups_;
};

}  // namespace

Scene build_scene(const SceneEntries& entries, const SceneSource& source) {
  return SceneBuilder(entries, source).build();
}

}  // namespace wuerfel
