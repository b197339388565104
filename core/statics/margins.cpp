#include "core/statics/margins.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/geometry/trig.h"
#include "core/statics/generators.h"
#include "core/statics/loads.h"
#include "core/statics/move_margins.h"
#include "core/statics/part_motions.h"
#include "core/statics/parts.h"
#include "core/statics/sets.h"

namespace wuerfel {
namespace {

LoadRange intersection(const LoadRange& a, const LoadRange& b) {
  return {std::max(a.low, b.low), std::min(a.high, b.high), std::max(a.error, b.error)};
}

/// Of load factors, 1.
constexpr double factor_rounding = 1e-8;

/// An end that is zero but for rounding, of a scene that stands, is zero: a knife edge, of which rounding may have crossed
/// both ends. A range that is farther from zero is not known.
LoadRange around_zero(const LoadRange& range, bool stands) {
  if (!stands) return range;
  const LoadRange known = around(0.0, range, factor_rounding);
  return {known.low + 0.0, known.high + 0.0, known.error};
}

std::optional<TiltMargin> tilt(const StillScene& still, Sliding sliding, double& error) {
  const LoadRange s = tilt_range(still, sliding);
  error = std::max(error, s.error);
  if (is_empty(s)) return std::nullopt;
  return tilt_angles(s);
}

Vec2 middle_of_highest_side(const StillScene& still, int cube) {
  const BodyState& at = still.state[cube];
  const Box box = make_box(at.position, at.angle, still.system.body(cube).size);
  int highest = 0;
  for (int e = 1; e < Box::corners; ++e) {
    const auto height = [&](int side) {
      return -still.down().dot(box.normal(side)) * box.reach(side);
    };
    if (height(e) > height(highest)) highest = e;
  }
  return box.center + box.normal(highest) * box.reach(highest);
}

/// Load factors over one island, from the cuts of its parts on.
class IslandLoads {
 public:
  IslandLoads(const StillScene& still, const Island& island, Sliding sliding)
      : IslandLoads(still, island, find_generators(still.system, still.state, island, sliding)) {}

  /// All s with forces that balance the weights and s q.
  LoadRange range(const Load& q) {
    Load reverse = q;
    for (double& x : reverse)
      x = -x;
    return factor_.range(weights_, q, motions_.cut(weights_, q), motions_.cut(weights_, reverse));
  }

 private:
  IslandLoads(const StillScene& still, const Island& island, const Generators& generators)
      : factor_(generators.program),
        weights_(weights(still, island)),
        motions_(still, island, generators) {}

  LoadFactor factor_;
  Load weights_;
  PartMotions motions_;
};

/// The margins of the cubes of one island.
class IslandMargins {
 public:
  IslandMargins(const StillScene& still, const IslandForces& of)
      : still_(still), of_(of), solver_(still, of.island, Sliding::given) {}

  LoadRange shift(int cube) {
    if (still_.system.body(cube).kind == BodyKind::point) return no_load;  // it has no room
    if (still_.system.gravity.isZero(0.0)) return {};                      // no weight, nowhere
    const double side = still_.system.body(cube).smaller_side();
    const double lever = side * still_.weight(cube);
    // A weight that acts at r turns with det(r, down) times itself.
    const double turn = det(still_.right(), still_.down());
    const Load q = torque_on(of_.island, cube, lever * turn);
    return around_zero(solver_.range(q), of_.rests).times(side);
  }

  LoadRange load(int cube) {
    const double weight = still_.weight(cube);
    const Load q = force_at(still_, of_.island, cube, middle_of_highest_side(still_, cube),
                            weight * still_.down());
    return around_zero(solver_.range(q), of_.rests).times(weight);
  }

 private:
  const StillScene& still_;
  const IslandForces& of_;
  IslandLoads solver_;
};

/// The least shift that changes the verdict of an island, as a share.
std::optional<double> smallest_of(const StillScene& still,
                                  const std::vector<BodyMargin>& bodies,
                                  int island,
                                  int& weakest) {
  std::optional<double> best;
  for (const BodyMargin& body : bodies) {
    if (still.island_of(body.cube) != island || is_empty(body.shift)) continue;
    const double share =
        std::min(-body.shift.low, body.shift.high) / still.system.body(body.cube).smaller_side();
    if (!std::isfinite(share)) continue;
    // What falls is nearest to standing where it has to be shifted least.
    const bool better = !best || (share < 0.0 || *best < 0.0 ? share > *best : share < *best);
    if (!better) continue;
    best = share;
    weakest = body.cube;
  }
  return best;
}

void find_smallest(const StillScene& still, Margins& margins) {
  for (int m = 0; m < static_cast<int>(still.found.islands.size()); ++m) {
    int weakest = -1;
    const std::optional<double> share = smallest_of(still, margins.bodies, m, weakest);
    if (!share || (margins.smallest && *margins.smallest <= *share)) continue;
    margins.smallest = share;
    margins.weakest = weakest;
  }
}

/// What a shift of its weight, as a share of its smaller side, can be at most for each cube of an
/// island: no part that it belongs to may leave its support.
std::vector<double> shares_at_most(const StillScene& still, const Island& island) {
  std::vector<double> most(still.system.cubes, unbounded);
  const PartJudge judge(still, island);
  for (const std::vector<int>& cubes : carried_parts(still, island)) {
    const PartStand part = judge.judge(cubes, Shift::of_all);
    const double shift = std::min(-part.shift.low, part.shift.high);
    for (const int cube : cubes) {
      const Body& body = still.system.body(cube);
      most[cube] = std::min(most[cube], shift * part.mass / (body.mass * body.smaller_side()));
    }
  }
  return most;
}

std::vector<int> cubes_of(const StillScene& still, const MarginRequest& request) {
  if (!request.cubes.empty()) return request.cubes;
  std::vector<int> all(still.system.cubes);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

void find_of_bodies(const StillScene& still,
                    const MotionSettings& settings,
                    const MarginRequest& request,
                    Margins& margins) {
  for (const int cube : cubes_of(still, request))
    margins.bodies.push_back({cube, no_load, no_load, no_load});
  for (int m = 0; m < static_cast<int>(still.found.islands.size()); ++m) {
    const Island& island = still.found.islands[m].island;
    IslandMargins of(still, still.found.islands[m]);
    MoveMargins moves(still, settings, m);
    for (BodyMargin& body : margins.bodies) {
      if (!has(island.cubes, body.cube)) continue;
      if (request.shift) body.shift = of.shift(body.cube);
      if (request.load) body.load = of.load(body.cube);
      if (request.move) body.move = moves.range(body.cube);
      margins.error = std::max({margins.error, body.shift.error, body.load.error, body.move.error});
    }
  }
}

}  // namespace

TiltMargin tilt_angles(const LoadRange& tangents) {
  const auto angle = [](double tangent) {
    return tangent == unbounded ? unbounded : atan2(tangent, 1.0);
  };
  return {angle(-tangents.low), angle(tangents.high)};
}

LoadRange tilt_range(const StillScene& still, Sliding sliding) {
  LoadRange range;
  if (still.system.gravity.isZero(0.0)) return range;
  for (int cube = 0; cube < still.system.cubes; ++cube)
    if (still.island_of(cube) < 0) return no_load;  // falls freely
  for (const IslandForces& of : still.found.islands) {
    const Load q = share_of_weights(still, of.island, still.right());
    const LoadRange own = IslandLoads(still, of.island, sliding).range(q);
    range = intersection(range, around_zero(own, of.rests));
    if (is_empty(range)) return no_load;
  }
  return range;
}

Margins find_margins(const StillScene& still,
                     const MotionSettings& settings,
                     const MarginRequest& request) {
  Margins margins;
  if (request.tilt) {
    margins.tilt = tilt(still, Sliding::given, margins.error);
    margins.tilt_no_sliding = tilt(still, Sliding::none, margins.error);
  }
  if (request.load || request.shift || request.move)
    find_of_bodies(still, settings, request, margins);
  find_smallest(still, margins);
  return margins;
}

/// Branch and bound.
std::optional<Weakest> find_weakest(const StillScene& still) {
  std::optional<Weakest> best;
  if (still.verdict != Verdict::stands || still.system.gravity.isZero(0.0)) return best;
  for (const IslandForces& of : still.found.islands) {
    const std::vector<double> most = shares_at_most(still, of.island);
    std::vector<int> order = of.island.cubes;
    std::ranges::stable_sort(order, {}, [&](int cube) { return most[cube]; });
    IslandMargins margins(still, of);
    for (const int cube : order) {
      if (best && most[cube] >= best->share) break;
      const LoadRange shift = margins.shift(cube);
      const double share =
          std::min(-shift.low, shift.high) / still.system.body(cube).smaller_side();
      if (std::isfinite(share) && (!best || share < best->share)) best = {cube, share, shift};
    }
  }
  return best;
}

}  // namespace wuerfel
