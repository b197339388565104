#include "core/statics/limit_motion.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/dynamics/gauss.h"
#include "core/dynamics/programs.h"
#include "core/qp/methods/equality_solver.h"
#include "core/statics/sets.h"

namespace wuerfel {
namespace {

constexpr int most_secants = 12;
/// Two secants that differ by no more than this share of the side are one place.
constexpr double last_digits = 1e-15;

/// The motion of one island just behind the end, and what is left of it elsewhere.
class LimitMotion {
 public:
  LimitMotion(const StillScene& still, const CarriedGroup& group) : still_(still), group_(group) {}

  /// False where nothing falls there without friction.
  bool find(const MotionSettings& settings, double s) {
    const State state = moved_state(still_, group_, s);
    const InstantForces found = forces_at(still_.system, settings, state, Detail::accelerations);
    const auto falls = [&](const IslandForces& of) {
      return !of.rests && !of.friction && has(of.island.cubes, group_.cubes[0]);
    };
    const auto of = std::ranges::find_if(found.islands, falls);
    if (of == found.islands.end()) return false;
    island_ = of->island;
    island_.touches.clear();
    island_.contacts.clear();
    const double most = of->solution.forces.empty() ? 0.0 : std::ranges::max(of->solution.forces);
    for (std::size_t k = 0; k < of->island.contacts.size(); ++k) {
      if (of->solution.forces[k] > pressing_share * most)
        island_.contacts.push_back(of->island.contacts[k]);
    }
    motion_ = free_motion(s);
    return true;
  }

  /// Power of gravity's part d(s) along the motion.
  [[nodiscard]] double at(double s) {
    const std::vector<double> d = free_motion(s);
    double sum = 0.0;
    for (std::size_t k = 0; k < d.size(); ++k)
      sum += mass_[k] * d[k] * motion_[k];
    return sum;
  }

 private:
  std::vector<double> free_motion(double s) {
    const State state = moved_state(still_, group_, s);
    pose_boxes(still_.system, state, boxes_);
    for (Contact& c : island_.contacts)
      c = at_poses(still_.system, boxes_, c);
    const std::vector<SideUse> use(island_.contacts.size(), SideUse::equality);
    ProgramBuilder builder(still_.system, Formulation::rigid);
    builder.acceleration(state, island_, use);
    mass_ = builder.program().mass;
    solver_.factorise(builder.program());
    std::vector<double> d;
    std::vector<double> multiplier;
    solver_.solve(builder.program(), d, multiplier);
    return d;
  }

  const StillScene& still_;
  const CarriedGroup& group_;
  Island island_;  ///< with the contacts that are pressed
  std::vector<Box> boxes_;
  std::vector<double> motion_;
  std::vector<double> mass_;
  EqualitySolver solver_;
};

}  // namespace

std::optional<double> end_of_rest(const StillScene& still,
                                  const MotionSettings& settings,
                                  const CarriedGroup& group,
                                  double before,
                                  double behind) {
  LimitMotion motion(still, group);
  if (!motion.find(settings, behind)) return std::nullopt;
  const double enough = last_digits * smallest_side(still, group);
  double s = before;
  double value = motion.at(s);
  double former = behind;
  double former_value = motion.at(former);
  for (int k = 0; k < most_secants && value != former_value; ++k) {
    const double next = s - value * (s - former) / (value - former_value);
    if (!(std::abs(next - s) <= std::abs(behind - before))) return std::nullopt;
    const bool last = std::abs(next - s) <= enough;
    former = s;
    former_value = value;
    s = next;
    value = motion.at(s);
    if (last || value == 0.0) return s;
  }
  return std::nullopt;
}

std::optional<double> end_of_touch(const StillScene& still,
                                   const CarriedGroup& group,
                                   double before,
                                   double room) {
  ContactFinder finder;
  std::optional<double> nearest;
  for (const Contact& c : finder.find(still.system, moved_state(still, group, before))) {
    const bool on = has(group.cubes, c.on);
    if (on == has(group.cubes, c.from)) continue;
    if (still.system.body(c.on).kind == BodyKind::plane
        || still.system.body(c.from).kind == BodyKind::plane)
      continue;
    const Box& own = finder.boxes()[on ? c.on : c.from];
    const Box& other = finder.boxes()[on ? c.from : c.on];
    for (int k = 0; k < Box::corners * Box::corners; ++k) {
      const double way =
          group.along.dot(other.corner(k / Box::corners) - own.corner(k % Box::corners));
      if (std::abs(way) <= room && (!nearest || std::abs(way) < std::abs(*nearest - before)))
        nearest = before + way;
    }
  }
  return nearest;
}

std::optional<double> end_of_room(const StillScene& still,
                                  const MotionSettings& settings,
                                  const CarriedGroup& group,
                                  double behind,
                                  double farther) {
  const MovedScene near = move(still, settings, group, behind);
  const MovedScene far = move(still, settings, group, farther);
  if (!near.overlaps || !far.overlaps || !(far.unrest > near.unrest)) return std::nullopt;
  return behind - near.unrest * (farther - behind) / (far.unrest - near.unrest);
}

}  // namespace wuerfel
