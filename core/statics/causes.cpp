#include "core/statics/causes.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/union_find.h"
#include "core/model/scales.h"
#include "core/statics/sets.h"

namespace wuerfel {
namespace {

/// Accelerations below this share of g, or of the largest one, are none.
constexpr double no_motion = 1e-9;
/// Motions that differ by less than this share of the largest are the same.
constexpr double same_motion = 1e-7;

int sign(double x) { return x > 0.0 ? 1 : x < 0.0 ? -1 : 0; }

/// Of every cube: its acceleration, or what proves that it cannot stay at rest.
std::vector<Twist> proof(const StillScene& still) {
  std::vector<Twist> motion = still.found.accelerations;
  for (const IslandForces& of : still.found.islands) {
    const bool virtual_motion = of.friction && !of.friction->certificate.empty();
    for (std::size_t k = 0; k < of.island.cubes.size(); ++k) {
      Twist& a = motion[of.island.cubes[k]];
      if (of.rests) a = {};
      if (virtual_motion) a = of.friction->certificate[k];
    }
  }
  return motion;
}

/// Rates of all generators of an island along a motion, per unit of force.
std::vector<double> rates(const Generators& generators,
                          const Island& island,
                          const std::vector<Twist>& motion) {
  std::vector<double> x;
  x.reserve(3 * island.cubes.size());
  for (const int cube : island.cubes)
    x.insert(x.end(), {motion[cube].linear.x(), motion[cube].linear.y(), motion[cube].angular});
  std::vector<double> rates;
  rates.reserve(generators.program.rows());
  for (int row = 0; row < generators.program.rows(); ++row)
    rates.push_back(generators.program.row_value(row, x));
  return rates;
}

Certificate certify(const StillScene& still) {
  Certificate certificate{proof(still)};
  for (int i = 0; i < still.system.cubes; ++i) {
    const double mass = still.system.body(i).mass;
    certificate.power += mass * still.system.gravity.dot(certificate.motion[i].linear);
  }
  for (const IslandForces& of : still.found.islands) {
    if (of.rests) continue;
    const Generators generators =
        find_generators(still.system, still.state, of.island, Sliding::given);
    for (const double rate : rates(generators, of.island, certificate.motion))
      certificate.worst_closing = std::min(certificate.worst_closing, rate);
  }
  return certificate;
}

/// The body at the other side of a contact of a part.
int partner(const PartStand& part, const Contact& c) {
  return has(part.cubes, c.on) ? c.from : c.on;
}

/// To where a part slides: along the sides that it presses on. The motion that proves that friction does not hold it leaves them
/// as well, the more the rougher they are.
Vec2 way_along(const Island& island, const PartStand& part) {
  if (part.presses.empty()) return part.motion.linear;
  Vec2 way = Vec2::Zero();
  for (const int k : part.presses) {
    const Contact& c = island.contacts[k];
    const Vec2 v = point_velocity(part.motion, c.point - part.centre);
    way += v - v.dot(c.normal) * c.normal;
  }
  return way;
}

/// What presses at more than one place is driven along by them, not over a corner.
bool presses_at_one_point(const Island& island, const PartStand& part) {
  const Contact& pivot = island.contacts[*part.pivot];
  return std::ranges::all_of(part.presses, [&](int k) {
    return (island.contacts[k].point - pivot.point).norm() <= touching_tolerance * pivot.length;
  });
}

Cause cause_of(const StillScene& still, int m, PartStand part) {
  Cause cause;
  cause.island = m;
  cause.part = std::move(part);
  const Island& island = still.found.islands[m].island;
  for (const int k : cause.part.presses)
    add_once(partner(cause.part, island.contacts[k]), cause.on);
  const LoadRange& shift = cause.part.shift;
  if (cause.part.pivot && !is_empty(shift) && presses_at_one_point(island, cause.part)) {
    cause.failure = FailureMode::tips;
    cause.corner = island.contacts[*cause.part.pivot].point;
    cause.sense = shift.low > 0.0 ? -1 : 1;
    cause.outside = shift.low > 0.0 ? shift.low : -shift.high;
    return cause;
  }
  cause.failure = FailureMode::slides;
  if (cause.on.empty())
    cause.failure = cause.part.on_rods ? FailureMode::swings : FailureMode::drops;
  const Vec2 way = way_along(island, cause.part);
  const double aside = way.dot(still.right());
  if (std::abs(aside) > no_motion * way.norm()) cause.sense = sign(aside);
  return cause;
}

/// Of the parts that carry one another only the first counts: they are the same.
void add_causes_of(const StillScene& still, int m, std::vector<Cause>& causes) {
  const Island& island = still.found.islands[m].island;
  const std::vector<std::vector<int>> parts = carried_parts(still, island);
  const PartJudge judge(still, island);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    PartStand part = judge.judge(parts[k], Shift::of_what_falls);
    const auto same = [&](const Cause& other) { return other.part.cubes == parts[k]; };
    if (part.stands() || std::ranges::any_of(causes, same)) continue;
    causes.push_back(cause_of(still, m, std::move(part)));
    causes.back().base = island.cubes[k];
  }
}

/// Cubes that touch nothing.
void add_free(const StillScene& still, std::vector<Cause>& causes) {
  if (still.system.gravity.isZero(0.0)) return;
  for (int i = 0; i < still.system.cubes; ++i) {
    if (still.island_of(i) >= 0) continue;
    Cause cause;
    cause.base = i;
    cause.part.cubes = {i};
    cause.part.mass = still.system.body(i).mass;
    cause.part.centre = still.state[i].position;
    cause.part.motion.linear = still.system.gravity;
    cause.part.shift = no_load;
    causes.push_back(cause);
  }
}

/// A motion carried over to another place of the same rigid body.
Twist carried_to(const Twist& motion, const Vec2& way) {
  return {point_velocity(motion, way), motion.angular};
}

/// The parts of an island's mechanism.
class Mechanism {
 public:
  Mechanism(const StillScene& still, int m, const Certificate& certificate)
      : still_(still), of_(still.found.islands[m]), certificate_(certificate) {
    for (const int cube : of_.island.cubes)
      largest_ = std::max(largest_, size(cube));
  }

  [[nodiscard]] std::vector<MovingPart> parts() const {
    const std::vector<int> group = groups();
    std::vector<MovingPart> parts;
    for (const int first : of_.island.cubes) {
      if (group[first] != first || size(first) <= same_motion * largest_) continue;
      parts.push_back(part(group, first));
    }
    return parts;
  }

 private:
  [[nodiscard]] double size(int cube) const {
    return size_of(still_.system.body(cube), certificate_.motion[cube]);
  }
  [[nodiscard]] bool closed(int k) const {
    return of_.solution.slacks[k] <= same_motion * largest_;
  }
  [[nodiscard]] bool alike(int i, int j) const {
    const Vec2 way = still_.state[j].position - still_.state[i].position;
    const Twist moved = carried_to(certificate_.motion[i], way);
    const Twist& other = certificate_.motion[j];
    return (moved.linear - other.linear).norm()
               + way.norm() * std::abs(moved.angular - other.angular)
           <= same_motion * largest_;
  }

  /// Per cube the first of those that move as one with it.
  [[nodiscard]] std::vector<int> groups() const {
    UnionFind joined(still_.system.cubes);
    for (std::size_t k = 0; k < of_.island.contacts.size(); ++k) {
      const Contact& c = of_.island.contacts[k];
      const bool cubes = still_.system.is_cube(c.on) && still_.system.is_cube(c.from);
      if (cubes && closed(static_cast<int>(k)) && alike(c.on, c.from)) joined.unite(c.on, c.from);
    }
    std::vector<int> group(still_.system.cubes, -1);
    for (const int cube : of_.island.cubes)
      group[cube] = joined.root(cube);
    return group;
  }

  [[nodiscard]] MovingPart part(const std::vector<int>& group, int first) const {
    MovingPart part;
    part.motion = certificate_.motion[first];
    const double turning = still_.system.body(first).smaller_side() * part.motion.angular;
    if (std::abs(turning) > same_motion * largest_) part.turn = sign(turning);
    for (const int cube : of_.island.cubes) {
      if (group[cube] != first) continue;
      part.cubes.push_back(cube);
      part.work_share += still_.system.body(cube).mass
                         * still_.system.gravity.dot(certificate_.motion[cube].linear)
                         / certificate_.power;
    }
    double hardest = 0.0;
    for (std::size_t k = 0; k < of_.island.contacts.size(); ++k) {
      const Contact& c = of_.island.contacts[k];
      const bool on = has(part.cubes, c.on);
      if (on == has(part.cubes, c.from)) continue;
      if (!closed(static_cast<int>(k))) add_once(on ? c.from : c.on, part.opens);
      if (of_.solution.forces[k] <= hardest) continue;
      hardest = of_.solution.forces[k];
      part.pivot = c.point;
    }
    return part;
  }

  const StillScene& still_;
  const IslandForces& of_;
  const Certificate& certificate_;
  double largest_ = 0.0;
};

std::vector<Cause> all_causes(const StillScene& still, std::vector<int>& without) {
  std::vector<Cause> causes;
  for (int m = 0; m < static_cast<int>(still.found.islands.size()); ++m) {
    if (still.found.islands[m].rests) continue;
    const std::size_t before = causes.size();
    add_causes_of(still, m, causes);
    if (causes.size() == before) without.push_back(m);
  }
  add_free(still, causes);
  std::ranges::stable_sort(causes, {}, [](const Cause& c) { return c.part.cubes.size(); });
  return causes;
}

}  // namespace

Causes find_causes(const StillScene& still) {
  Causes result;
  if (still.verdict == Verdict::stands) return result;
  result.certificate = certify(still);
  std::vector<int> without;
  result.causes = all_causes(still, without);
  for (const int m : without) {
    for (MovingPart& part : Mechanism(still, m, result.certificate).parts())
      result.mechanism.push_back(std::move(part));
  }
  return result;
}

std::optional<Cause> first_cause(const StillScene& still) {
  if (still.verdict == Verdict::stands) return std::nullopt;
  std::vector<int> without;
  const std::vector<Cause> causes = all_causes(still, without);
  if (causes.empty()) return std::nullopt;
  return causes.front();
}

}  // namespace wuerfel
