#include "core/statics/fixes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/dynamics/programs.h"
#include "core/model/scales.h"
#include "core/qp/coulomb/rest_program.h"
#include "core/statics/carried.h"
#include "core/statics/move_margins.h"
#include "core/statics/sets.h"

namespace wuerfel {
namespace {

/// Cubes that are looked at: of large piles those that fail first.
constexpr int most_cubes = 24;
/// Moves, and forces, of one island.
constexpr std::size_t most_fixes = 3;
/// Forces, and places as shares of a side, that differ by less are the same.
constexpr double same = 1e-9;
/// By which a force is larger where it may or may not stand with the least one.
constexpr double beyond_rounding = 1e-9;

/// |a| + side |alpha| of the cube that it is largest for, m/s^2.
double largest(const StillScene& still, const Island& island, const std::vector<Twist>& a) {
  double e = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k)
    e = std::max(e, size_of(still.system.body(island.cubes[k]), a[k]));
  return e;
}

Verdict verdict_of(double share) {
  if (share <= stands_below) return Verdict::stands;
  return share >= falls_above ? Verdict::falls : Verdict::undecided;
}

/// A force at a corner, with the least that it has to be.
struct Hold {
  int cube = 0;
  Vec2 point = Vec2::Zero();
  Vec2 direction = Vec2::Zero();
  double at_least = 0.0;  ///< N
};

/// Forces that resist the motion, the ones that need least first. In the motion the weights have a
/// power; a force that does not take it all leaves some.
std::vector<Hold> holds(const StillScene& still,
                        const Island& island,
                        const std::vector<int>& cubes,
                        const Certificate& certificate) {
  const Vec2 right = still.right();
  double power = 0.0;
  std::vector<Hold> found;
  for (const int cube : cubes) {
    if (still.system.body(cube).kind == BodyKind::point) continue;  // no corner to hold
    const BodyState& at = still.state[cube];
    const Box box = make_box(at.position, at.angle, still.system.body(cube).size);
    const Twist& a = certificate.motion[cube];
    for (int k = 0; k < Box::corners; ++k) {
      const Vec2 v = point_velocity(a, box.arm[k]);
      for (const Vec2& direction : {Vec2(-still.down()), still.down(), right, Vec2(-right)}) {
        const double taken = -direction.dot(v);
        if (taken > 0.0) found.push_back({cube, box.corner(k), direction, taken});
      }
    }
  }
  for (const int i : island.cubes)
    power += still.system.body(i).mass * still.system.gravity.dot(certificate.motion[i].linear);
  for (Hold& hold : found)
    hold.at_least = power / hold.at_least;
  std::ranges::stable_sort(found, {}, &Hold::at_least);
  return found;
}

void keep_smallest(std::vector<Fix>& fixes) {
  std::ranges::stable_sort(fixes, {}, &Fix::size);
  if (fixes.size() > most_fixes) fixes.resize(most_fixes);
}

/// How far the point of a force is from the cube's centre against the force, which pushes there, against gravity, and the way that
/// the cube goes, m.
std::array<double, 3> handiness(const StillScene& still, const Fix& fix, const Twist& motion) {
  const Vec2 arm = fix.point - still.state[fix.cube].position;
  return {-arm.dot(fix.force.normalized()), -arm.dot(still.down()),
          arm.dot(motion.linear.normalized())};
}

/// Of equal forces it is the one that pushes, not pulls, then the one farther up, then ahead.
bool is_better(const StillScene& still, const Fix& fix, const Fix& other, const Twist& motion) {
  const double more = fix.size() - other.size();
  if (std::abs(more) > same * other.size()) return more < 0.0;
  const double least = same * still.system.body(fix.cube).smaller_side();
  const std::array<double, 3> mine = handiness(still, fix, motion);
  const std::array<double, 3> others = handiness(still, other, motion);
  for (std::size_t k = 0; k < mine.size(); ++k)
    if (std::abs(mine[k] - others[k]) > least) return mine[k] > others[k];
  return false;
}

void verify(const StillScene& still, Fix& fix) {
  fix.verified = verdict_with_force(still, fix.cube, fix.point, fix.force);
  if (fix.verified != Verdict::undecided) return;
  fix.force *= 1.0 + beyond_rounding;
  fix.verified = verdict_with_force(still, fix.cube, fix.point, fix.force);
}

/// The best force on each cube.
std::vector<Fix> forces(const StillScene& still,
                        const IslandForces& of,
                        const std::vector<int>& cubes,
                        const Certificate& certificate) {
  LoadFactor factor(find_generators(still.system, still.state, of.island, Sliding::given).program);
  const Load w = weights(still, of.island);
  std::vector<Fix> fixes;
  for (const Hold& hold : holds(still, of.island, cubes, certificate)) {
    if (fixes.size() == most_fixes && hold.at_least > (1.0 + same) * fixes.back().size()) break;
    const double unit = still.weight(hold.cube);
    const Load q = force_at(still, of.island, hold.cube, hold.point, unit * hold.direction);
    const double s = factor.low(w, q);
    if (!std::isfinite(s) || s <= 0.0) continue;
    Fix fix;
    fix.kind = Fix::Kind::force;
    fix.cube = hold.cube;
    fix.point = hold.point;
    fix.force = s * unit * hold.direction;
    const auto former = std::ranges::find(fixes, hold.cube, &Fix::cube);
    if (former != fixes.end() && !is_better(still, fix, *former, certificate.motion[hold.cube]))
      continue;
    verify(still, fix);
    if (fix.verified != Verdict::stands) continue;
    if (former != fixes.end()) fixes.erase(former);
    fixes.push_back(fix);
    keep_smallest(fixes);
  }
  return fixes;
}

std::vector<Fix> moves(const StillScene& still,
                       const MotionSettings& settings,
                       const std::vector<int>& cubes) {
  std::vector<Fix> fixes;
  for (const int cube : cubes) {
    const std::optional<double> distance = mending_move(still, settings, cube);
    if (!distance) continue;
    const CarriedGroup group = *carried_group(still, cube);
    Fix fix;
    fix.cube = cube;
    fix.distance = *distance;
    fix.carried = static_cast<int>(group.cubes.size());
    fix.along = group.along;
    fix.point = still.state[cube].position;
    fix.verified = move(still, settings, group, *distance).verdict;
    if (fix.verified == Verdict::stands) fixes.push_back(fix);
  }
  keep_smallest(fixes);
  return fixes;
}

/// The cubes of an island that take part in what fails, those that fail first before the others.
std::vector<int> concerned(const Island& island, int m, const Causes& causes) {
  std::vector<int> cubes;
  const auto add = [&](const std::vector<int>& more) {
    for (const int cube : more)
      if (static_cast<int>(cubes.size()) < most_cubes) add_once(cube, cubes);
  };
  for (const Cause& cause : causes.causes)
    if (cause.island == m) add(cause.part.cubes);
  for (const MovingPart& part : causes.mechanism)
    if (has(island.cubes, part.cubes.front())) add(part.cubes);
  return cubes;
}

}  // namespace

Verdict verdict_with_force(const StillScene& still,
                           int cube,
                           const Vec2& point,
                           const Vec2& force) {
  const Island& island = still.found.islands[still.island_of(cube)].island;
  ProgramBuilder builder(still.system, Formulation::rigid);
  builder.acceleration(still.state, island);
  if (still.system.rubs) builder.add_friction(still.state, island);
  QuadraticProgram program = builder.program();
  const Load load = force_at(still, island, cube, point, force);
  for (int k = 0; k < program.unknowns(); ++k)
    program.target[k] += load[k] / program.mass[k];
  const double g = still.weight(cube) / still.system.body(cube).mass;
  const auto judge = [&](const std::vector<double>& x) {
    return verdict_of(largest(still, island, builder.twists(still.state, island, x)) / g);
  };
  if (still.system.rubs) {
    const RestResult rest = RestProgram().solve({program, builder.friction_program().contacts});
    return rest.equilibrium() ? Verdict::stands : judge(rest.acceleration);
  }
  QpResult result;
  make_qp_solver(QpMethod::automatic, {.by_block = true})->solve(program, result);
  return result.status == QpStatus::optimal ? judge(result.x) : Verdict::undecided;
}

std::vector<Fix> find_fixes(const StillScene& still,
                            const MotionSettings& settings,
                            const Causes& causes) {
  std::vector<Fix> fixes;
  for (int m = 0; m < static_cast<int>(still.found.islands.size()); ++m) {
    const IslandForces& of = still.found.islands[m];
    if (of.rests) continue;
    const std::vector<int> cubes = concerned(of.island, m, causes);
    for (Fix& fix : moves(still, settings, cubes))
      fixes.push_back(fix);
    for (Fix& fix : forces(still, of, cubes, causes.certificate))
      fixes.push_back(fix);
  }
  return fixes;
}

}  // namespace wuerfel
