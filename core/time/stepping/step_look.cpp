#include "core/time/stepping/step_look.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/momentum.h"
#include "core/time/stepping/rattle_stepper.h"

namespace wuerfel {
namespace {

/// Place of a cube at `share` of a step of `h` s. What is struck, so that its velocity changes by
/// more than `rough` (m/s), flies on until it is: the instant follows from the way it has come.
BodyState way_between(const BodyState& from,
                      const BodyState& to,
                      double h,
                      double share,
                      double radius,
                      double rough) {
  const Vec2 change = to.velocity - from.velocity;
  const double turn = radius * (to.spin - from.spin);
  const double square = change.squaredNorm() + turn * turn;
  const Vec2 way = to.position - from.position;
  BodyState state = from;
  if (square <= rough * rough) {
    // The cubic that has both places and velocities.
    const double s = share;
    const double to_end = s * s * (3.0 - 2.0 * s);
    const double by_first = s * (1.0 - s) * (1.0 - s) * h;
    const double by_last = s * s * (1.0 - s) * h;
    state.position += to_end * way + by_first * from.velocity - by_last * to.velocity;
    state.angle += to_end * (to.angle - from.angle) + by_first * from.spin - by_last * to.spin;
    return state;
  }
  const double flown =
      change.dot(way - h * to.velocity) + radius * turn * (to.angle - from.angle - h * to.spin);
  const double struck = std::clamp(-flown / (h * square), 0.0, 1.0);
  const double before = h * std::min(share, struck);
  const double after = h * std::max(share - struck, 0.0);
  // What these two ways miss of the whole one is made up for on the way.
  const Vec2 missed = way - h * (struck * from.velocity + (1.0 - struck) * to.velocity);
  const double missed_turn =
      to.angle - from.angle - h * (struck * from.spin + (1.0 - struck) * to.spin);
  state.position += before * from.velocity + after * to.velocity + share * missed;
  state.angle += before * from.spin + after * to.spin + share * missed_turn;
  return state;
}

/// Velocities of looks are scaled up by no more than this factor: between the blows of a step in which one cube strikes
/// several others there may be half of the energy.
constexpr double most_given_back = 1.5;

/// Looks may not depend on other looks.
MotionSettings without_memory(MotionSettings settings) {
  settings.skips.certificate = false;
  settings.skips.warm_start = false;
  return settings;
}

}  // namespace

StepLook::StepLook(const System& system, const MotionSettings& settings)
    : system_(&system), work_(system, without_memory(settings), step_tolerances), removal_(work_) {}

State StepLook::between(const State& from, const State& to, double h, double share) const {
  const double rough = rough_steps * scales_of(*system_, from).gravity * h;
  State state = from;
  for (std::size_t i = 0; i < state.size(); ++i)
    state[i] = way_between(from[i], to[i], h, share, system_->bodies[i].radius(), rough);
  return state;
}

/// Velocities of the start, changed by gravity and by the impulses up to then. What is still missing at the end comes
/// evenly.
void StepLook::set_velocities(const State& from,
                              const State& to,
                              double h,
                              double share,
                              const StepRecord& record,
                              State& state) const {
  State end = from;
  for (std::size_t i = 0; i < state.size(); ++i) {
    state[i].velocity = from[i].velocity + share * h * system_->gravity;
    state[i].spin = from[i].spin;
    end[i].velocity += h * system_->gravity;
  }
  const auto add = [&](int cube, const Vec2& linear, double turn, double part, State& sum) {
    if (!system_->is_cube(cube)) return;
    const Body& body = system_->body(cube);
    sum[cube].velocity += part / body.mass * linear;
    sum[cube].spin += part / body.inertia * turn;
  };
  for (const StepImpulse& p : record.impulses) {
    const double part = p.end > p.begin
                            ? std::clamp((share - p.begin) / (p.end - p.begin), 0.0, 1.0)
                            : (share >= p.begin ? 1.0 : 0.0);
    add(p.on, p.linear, p.turn_on, part, state);
    add(p.from, -p.linear, p.turn_from, part, state);
    add(p.on, p.linear, p.turn_on, 1.0, end);
    add(p.from, -p.linear, p.turn_from, 1.0, end);
  }
  for (std::size_t i = 0; i < state.size(); ++i) {
    state[i].velocity += share * (to[i].velocity - end[i].velocity);
    state[i].spin += share * (to[i].spin - end[i].spin);
  }
}

/// Angular momentum changes by gravity alone where nothing fixed is touched.
void StepLook::turn_on(const StepComponent& part, const State& from, double t, State& state) const {
  if (!part.fixed_normals.empty()) return;
  const Momentum before = momentum_of(*system_, from, part.cubes);
  const Momentum now = momentum_of(*system_, state, part.cubes);
  const Vec2& g = system_->gravity;
  const double due = before.angular + det(before.center, before.linear)
                     + t * det(before.mass * before.center + 0.5 * t * before.linear, g);
  const double spin = (due - now.angular - det(now.center, now.linear)) / now.inertia;
  turn(*system_, part.cubes, {now.center, Vec2::Zero(), spin}, state);
}

void StepLook::settle_energy(const StepComponent& part,
                             const State& from,
                             const State& to,
                             double share,
                             State& state) const {
  const double start = energy_of(*system_, from, part.cubes);
  double goal = start;
  double all = 0.0;
  for (const StepLoss& loss : part.losses) {
    all += loss.energy;
    if (loss.friction) {
      goal -= share * loss.energy;
    } else if (loss.share <= share) {
      goal -= loss.energy;
    }
  }
  goal += share * (energy_of(*system_, to, part.cubes) - (start - all));
  const RigidMotion kept =
      kept_motion(momentum_of(*system_, state, part.cubes), part.fixed_normals);
  scale_to_energy(*system_, part.cubes, kept, goal, most_given_back, state);
}

State StepLook::at(
    const State& from, const State& to, double h, double share, const StepRecord& record) {
  State state = between(from, to, h, share);
  set_velocities(from, to, h, share, record, state);
  for (const StepComponent& part : record.components)
    turn_on(part, from, share * h, state);
  const State uncleaned = state;
  removal_.begin(from, h);
  Bookkeeping aside;
  const std::vector<Contact> cleaned = removal_.clean_up(state, aside);
  if (removal_.left() > overlap_share) removal_.retreat(state);
  keep_turning(*system_, cleaned, uncleaned, state);
  for (const StepComponent& part : record.components)
    settle_energy(part, from, to, share, state);
  return state;
}

}  // namespace wuerfel
