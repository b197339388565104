#include "core/scene/scene_checks.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/scene/scene_parser.h"

namespace wuerfel {
namespace {

std::int64_t cubes_of(const SceneEntries& entries) {
  auto cubes = static_cast<std::int64_t>(entries.cubes.size());
  for (const TowerEntry& tower : entries.towers) {
    cubes += tower.count;
  }
  for (const WallEntry& wall : entries.walls) {
    cubes += wall.rows * (wall.columns + 1);
  }
  for (const PyramidEntry& pyramid : entries.pyramids) {
    cubes += pyramid.rows * (pyramid.rows + 1) / 2;
  }
  for (const PileEntry& pile : entries.piles) {
    cubes += pile.count;
  }
  for (const ChainEntry& chain : entries.chains)
    if (chain.link) cubes += chain.count;
  return cubes;
}

std::int64_t points_of(const SceneEntries& entries) {
  auto points = static_cast<std::int64_t>(entries.points.size());
  for (const ChainEntry& chain : entries.chains)
    if (!chain.link) points += chain.count;
  for (const TrussEntry& truss : entries.trusses)
    points += 2 * truss.count + 1;
  return points;
}

bool is_within(const Limits& limits, double value) {
  return value >= limits.min && value <= limits.max;
}

/// Of masses farther apart the weight of the lighter one is lost in the rounding of the heavier one.
constexpr double most_mass_ratio = 1e16;
/// A body farther out than so many of its sides has its corners and its centre in one place.
constexpr double most_distance_ratio = 1e15;

struct Weighed {
  BodyRef body;
  double mass = 0.0;
};

/// The lightest and the heaviest of what moves, of which there is something.
std::pair<Weighed, Weighed> extremes(const Scene& scene) {
  std::vector<Weighed> all;
  for (std::size_t i = 0; i < scene.cubes.size(); ++i)
    all.push_back({{BodyKind::cube, static_cast<int>(i)}, scene.cubes[i].mass});
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    all.push_back({{BodyKind::point, static_cast<int>(i)}, scene.points[i].mass});
  return {*std::ranges::min_element(all, {}, &Weighed::mass),
          *std::ranges::max_element(all, {}, &Weighed::mass)};
}

void check_masses(const Scene& scene, const Groups& groups, const SceneSource& source) {
  const auto [light, heavy] = extremes(scene);
  if (heavy.mass <= most_mass_ratio * light.mass) return;
  const Origin& first = *groups.of(light.body).origin;
  const Origin& second = *groups.of(heavy.body).origin;
  const bool light_is_later = written_before(second.table->place, first.table->place);
  const Origin& later = light_is_later ? first : second;
  source.fail(
      place_of(later, "mass"), later.path,
      fmt::format(
          "\"{}\" has {:g} kg and \"{}\" {:g} kg, out of range of each other: more than {:.0g} to "
          "one cannot be computed with 16 digits; bring them closer, or make a [[fixed]] box of "
          "the heavy one",
          body_name(scene, light.body), light.mass, body_name(scene, heavy.body), heavy.mass,
          most_mass_ratio));
}

}  // namespace

void check_counts(const SceneEntries& entries, const SceneSource& source) {
  const std::int64_t cubes = cubes_of(entries);
  const std::int64_t points = points_of(entries);
  if (cubes + points == 0) {
    source.fail({}, "", "the scene has no cubes; add a [[cube]] or a generator such as [[tower]]");
  }
  const std::int64_t bodies = cubes + points + static_cast<std::int64_t>(entries.fixed.size());
  if (bodies > most_bodies) {
    source.fail(
        {}, "",
        fmt::format("the scene has {} cubes, points and fixed boxes; at most {} are allowed",
                    bodies, most_bodies));
  }
  if (static_cast<std::int64_t>(entries.planes.size()) > most_planes) {
    source.fail({}, "",
                fmt::format("the scene has {} planes; at most {} are allowed",
                            entries.planes.size(), most_planes));
  }
}

void check_ranges(const Scene& scene, const Groups& groups, const SceneSource& source) {
  const auto check = [&](const BodyRef& body, const Vec2& position, double angle, double mass) {
    const bool fits = is_within(limits::coordinate, position.x())
                      && is_within(limits::coordinate, position.y())
                      && is_within(limits::angle, angle) && is_within(limits::mass, mass);
    if (fits) return;
    fail_at(source, *groups.of(body).origin,
            fmt::format("\"{}\" would have position [{}, {}], angle {} and mass {}, out of range",
                        body_name(scene, body), position.x(), position.y(), angle, mass));
  };
  const auto check_place = [&](const BodyRef& body, const Vec2& position, const Vec2& size) {
    const double far = position.cwiseAbs().maxCoeff();
    if (far <= most_distance_ratio * size.minCoeff()) return;
    fail_at(source, *groups.of(body).origin,
            fmt::format("\"{}\", {} m wide, would have position [{}, {}], out of range: so far "
                        "out its corners are where its centre is; place it nearer to the "
                        "origin or make it larger",
                        body_name(scene, body), size.minCoeff(), position.x(), position.y()));
  };
  for (std::size_t i = 0; i < scene.fixed.size(); ++i) {
    check({BodyKind::fixed, static_cast<int>(i)}, scene.fixed[i].position, scene.fixed[i].angle,
          1.0);
  }
  for (std::size_t i = 0; i < scene.cubes.size(); ++i) {
    const SceneCube& cube = scene.cubes[i];
    check({BodyKind::cube, static_cast<int>(i)}, cube.position, cube.angle, cube.mass);
  }
  for (std::size_t i = 0; i < scene.fixed.size(); ++i) {
    check_place({BodyKind::fixed, static_cast<int>(i)}, scene.fixed[i].position,
                scene.fixed[i].size);
  }
  for (std::size_t i = 0; i < scene.cubes.size(); ++i) {
    check_place({BodyKind::cube, static_cast<int>(i)}, scene.cubes[i].position,
                scene.cubes[i].size);
  }
  check_masses(scene, groups, source);
}

void check_overlap(const Scene& scene, const Groups& groups, const SceneSource& source) {
  const std::optional<Overlap> overlap = find_overlap(scene);
  if (!overlap) return;
  const Origin& first = *groups.of(overlap->first).origin;
  const Origin& second = *groups.of(overlap->second).origin;
  const Origin& later = written_before(second.table->place, first.table->place) ? first : second;
  // Points know no `on`.
  const bool can_stand = overlap->second.kind != BodyKind::point;
  const std::string_view otherwise = can_stand ? ", or let one stand on the other with `on`" : "";
  try {
    fail_at(source, later,
            fmt::format("{}; move them apart{}", overlap_message(scene, *overlap), otherwise));
  } catch (const SceneError& error) {
    throw OverlapError(error.what());
  }
}

}  // namespace wuerfel
