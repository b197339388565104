#include "core/time/stepping/step_look.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/momentum.h"
#include "core/time/stepping/rattle_stepper.h"

namespace wuerfel {
namespace {

/// How much of an impulse has acted by a share of the step, and the integral of that.
struct Part {
  double done = 0.0;
  double sum = 0.0;
};

Part part_of(const StepImpulse& p, double share) {
  if (share < p.begin) return {};
  if (share >= p.end) return {1.0, share - 0.5 * (p.begin + p.end)};
  const double since = share - p.begin;
  const double done = since / (p.end - p.begin);
  return {done, 0.5 * done * since};
}

/// Onto the cubic that has both places and velocities.
void place_smoothly(
    const BodyState& from, const BodyState& to, double h, double share, BodyState& state) {
  const double s = share;
  const double to_end = s * s * (3.0 - 2.0 * s);
  const double by_first = s * (1.0 - s) * (1.0 - s) * h;
  const double by_last = s * s * (1.0 - s) * h;
  state.position = from.position + to_end * (to.position - from.position) + by_first * from.velocity
                   - by_last * to.velocity;
  state.angle =
      from.angle + to_end * (to.angle - from.angle) + by_first * from.spin - by_last * to.spin;
}

/// Velocities of looks are scaled up by no more than this factor: between the blows of a step in which one cube strikes
/// several others there may be half of the energy.
constexpr double most_given_back = 3.0;

/// Looks may not depend on other looks.
MotionSettings without_memory(MotionSettings settings) {
  settings.skips.certificate = false;
  settings.skips.warm_start = false;
  return settings;
}

}  // namespace

StepLook::StepLook(const System& system, const MotionSettings& settings)
    : system_(&system), work_(system, without_memory(settings), step_tolerances), removal_(work_) {}

/// From the start by gravity and the impulses up to a share of the step.
State StepLook::fly(const State& from, double h, double share, const StepRecord& record) const {
  State state = from;
  const double t = share * h;
  for (BodyState& s : state) {
    s.position += t * s.velocity + 0.5 * t * t * system_->gravity;
    s.angle += t * s.spin;
    s.velocity += t * system_->gravity;
  }
  const auto push = [&](int cube, const Vec2& linear, double turn, const Part& part) {
    if (!system_->is_cube(cube)) return;
    const Body& body = system_->body(cube);
    BodyState& s = state[cube];
    s.velocity += part.done / body.mass * linear;
    s.position += h * part.sum / body.mass * linear;
    s.spin += part.done / body.inertia * turn;
    s.angle += h * part.sum / body.inertia * turn;
  };
  for (const StepImpulse& p : record.impulses) {
    const Part part = part_of(p, share);
    push(p.on, p.linear, p.turn_on, part);
    push(p.from, -p.linear, p.turn_from, part);
  }
  return state;
}

/// What flight and impulses miss of the end comes evenly; what is not struck goes smoothly.
State StepLook::between(
    const State& from, const State& to, double h, double share, const StepRecord& record) const {
  const double rough = rough_steps * scales_of(*system_, from).gravity * h;
  State state = fly(from, h, share, record);
  const State end = fly(from, h, 1.0, record);
  for (std::size_t i = 0; i < state.size(); ++i) {
    BodyState& s = state[i];
    s.velocity += share * (to[i].velocity - end[i].velocity);
    s.spin += share * (to[i].spin - end[i].spin);
    const Vec2 change = to[i].velocity - from[i].velocity;
    const double turn = system_->bodies[i].radius() * (to[i].spin - from[i].spin);
    if (change.squaredNorm() + turn * turn <= rough * rough) {
      place_smoothly(from[i], to[i], h, share, s);
    } else {
      s.position += share * (to[i].position - end[i].position);
      s.angle += share * (to[i].angle - end[i].angle);
    }
  }
  return state;
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
    goal -= loss.by(share);
  }
  goal += share * (energy_of(*system_, to, part.cubes) - (start - all));
  const RigidMotion kept =
      kept_motion(momentum_of(*system_, state, part.cubes), part.fixed_normals);
  scale_to_energy(*system_, part.cubes, kept, goal, most_given_back, state);
}

State StepLook::at(
    const State& from, const State& to, double h, double share, const StepRecord& record) {
  State state = between(from, to, h, share, record);
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
