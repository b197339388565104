#include "core/time/stepping/step_look.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/dynamics/momentum.h"
#include "core/time/stepping/rattle_stepper.h"
#include "core/time/stepping/step_energy.h"

namespace wuerfel {
namespace {

/// Of the change of velocity, by which ways of smooth motions miss the mean velocity.
constexpr double most_missed = 0.1;

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

/// Whether velocities that change evenly lead from one place to the other, but for ways across gravity. What rises and is
/// back before the step has passed would rise too far on the cubic.
bool is_smooth(
    const BodyState& from, const BodyState& to, double h, double radius, const Vec2& up) {
  const auto size = [&](const Vec2& v, double spin) {
    return std::abs(v.dot(up)) + radius * std::abs(spin);
  };
  const Vec2 missed = 0.5 * (from.velocity + to.velocity) - (to.position - from.position) / h;
  const double missed_spin = 0.5 * (from.spin + to.spin) - (to.angle - from.angle) / h;
  return size(missed, missed_spin)
         <= most_missed * size(to.velocity - from.velocity, to.spin - from.spin);
}

/// A blow, by what it changes of a cube's velocities.
struct Jump {
  double share = 0.0;
  Twist by;
};

/// Straight on from blow to blow. What blows miss of the change of velocity (the weight is carried afterwards) belongs to
/// them in proportion, what that misses of the way comes evenly. Blows of a step stand one after the other that act at once
/// where a light cube is squeezed between heavy ones, so that it goes no farther astray than its speed at the ends takes it.
void place_struck(const Body& body,
                  const BodyState& from,
                  const BodyState& to,
                  double h,
                  double share,
                  const std::vector<Jump>& jumps,
                  BodyState& state) {
  Vec2 missed = to.velocity - from.velocity;
  double missed_spin = to.spin - from.spin;
  double all = 0.0;
  for (const Jump& j : jumps) {
    missed -= j.by.linear;
    missed_spin -= j.by.angular;
    all += fastest_corner(body, j.by);
  }
  Vec2 astray = Vec2::Zero();
  double turned = 0.0;
  for (const Jump& j : jumps) {
    const double way = h * (std::max(0.0, share - j.share) - share * (1.0 - j.share));
    const double part = fastest_corner(body, j.by) / all;
    astray += way * (j.by.linear + part * missed);
    turned += way * (j.by.angular + part * missed_spin);
  }
  const double farthest = h * (fastest_corner(body, from) + fastest_corner(body, to));
  const double far = fastest_corner(body, Twist{astray, turned});
  const double kept = far > farthest ? farthest / far : 1.0;
  state.position = from.position + share * (to.position - from.position) + kept * astray;
  state.angle = from.angle + share * (to.angle - from.angle) + kept * turned;
}

/// Velocities of looks are scaled up by no more than this factor: between the blows of a step in which one cube strikes
/// several others there may be half of the energy.
constexpr double most_scaled_up = 3.0;

/// A clean-up of a look moves no cube by more than this share of its smaller side: a light one below a heavy one would be
/// pushed out from there, to others that are not of its group.
constexpr double most_cleaned = 0.1;

bool is_pushed_out(const System& system, const State& from, const State& to) {
  for (int i = 0; i < system.cubes; ++i) {
    if ((to[i].position - from[i].position).norm() > most_cleaned * system.body(i).smaller_side())
      return true;
  }
  return false;
}

/// Looks may not depend on other looks.
MotionSettings without_memory(MotionSettings settings) {
  settings.skips.certificate = false;
  settings.skips.warm_start = false;
  return settings;
}

}  // namespace

StepLook::StepLook(const System& system, const MotionSettings& settings)
    : system_(&system),
      work_(system, without_memory(settings), step_tolerances(system)),
      removal_(work_) {}

/// Places on the way from one state to the other.
State StepLook::between(
    const State& from, const State& to, double h, double share, const StepRecord& record) const {
  std::vector<std::vector<Jump>> jumps(from.size());
  const auto add = [&](int cube, double at, const Vec2& linear, double turn) {
    if (!system_->is_cube(cube)) return;
    const Body& body = system_->body(cube);
    jumps[cube].push_back({at, {linear / body.mass, turn / body.inertia}});
  };
  for (const StepImpulse& p : record.impulses) {
    if (p.begin != p.end) continue;
    add(p.on, p.begin, p.linear, p.turn_on);
    add(p.from, p.begin, -p.linear, p.turn_from);
  }
  const double rough = rough_steps * scales_of(*system_, from).gravity * h;
  const Vec2 up = -system_->gravity.normalized();
  State state = from;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Body& body = system_->bodies[i];
    const Vec2 change = to[i].velocity - from[i].velocity;
    const double turn = body.radius() * (to[i].spin - from[i].spin);
    if (change.squaredNorm() + turn * turn > rough * rough) {
      place_struck(body, from[i], to[i], h, share, jumps[i], state[i]);
    } else if (is_smooth(from[i], to[i], h, body.radius(), up)) {
      place_smoothly(from[i], to[i], h, share, state[i]);
    } else {
      place_struck(body, from[i], to[i], h, share, {}, state[i]);
    }
  }
  return state;
}

/// Velocities change evenly, but for what blows do: all cubes of a component have it from its last blow on, for what one cube
/// squeezes against another passes through both at once. Until then gravity moves what nothing bears.
void StepLook::set_velocities(const State& from,
                              const State& to,
                              double h,
                              double share,
                              const StepRecord& record,
                              State& state) const {
  struct Change {
    Twist pushed;          // by impulses
    bool borne = false;    // from the beginning on
    double struck = -1.0;  // share of the step; not at all: -1
  };
  std::vector<Change> changes(from.size());
  const auto add = [&](int cube, const StepImpulse& p, const Vec2& linear, double turn) {
    if (!system_->is_cube(cube)) return;
    Change& change = changes[cube];
    change.pushed.linear += linear / system_->body(cube).mass;
    change.pushed.angular += turn / system_->body(cube).inertia;
    if (p.begin == p.end) {
      change.struck = std::max(change.struck, p.begin);
    } else if (p.begin == 0.0) {
      change.borne = true;
    }
  };
  for (const StepImpulse& p : record.impulses) {
    add(p.on, p, p.linear, p.turn_on);
    add(p.from, p, -p.linear, p.turn_from);
  }
  for (const StepComponent& part : record.components) {
    double last = -1.0;
    for (const int cube : part.cubes)
      last = std::max(last, changes[cube].struck);
    for (const int cube : part.cubes)
      changes[cube].struck = last;
  }
  const Vec2 fall = h * system_->gravity;
  for (std::size_t i = 0; i < state.size(); ++i) {
    // What impulses leave out comes evenly.
    Twist even{to[i].velocity - from[i].velocity, to[i].spin - from[i].spin};
    Twist blow;
    if (changes[i].struck >= 0.0) {
      blow = changes[i].pushed;
      if (changes[i].borne) blow.linear += fall;
      even = {even.linear - blow.linear, even.angular - blow.angular};
    }
    const double part = share >= changes[i].struck ? 1.0 : 0.0;
    state[i].velocity = from[i].velocity + share * even.linear + part * blow.linear;
    state[i].spin = from[i].spin + share * even.angular + part * blow.angular;
  }
}

/// Angular momentum changes by gravity alone where nothing fixed is touched.
void StepLook::turn_on(const StepComponent& part, const State& from, double t, State& state) const {
  if (!part.held_along.empty()) return;
  const Momentum before = momentum_of(*system_, from, part.cubes);
  const Momentum now = momentum_of(*system_, state, part.cubes);
  const Vec2& g = system_->gravity;
  const double due = before.angular + det(before.center, before.linear)
                     + t * det(before.mass * before.center + 0.5 * t * before.linear, g);
  const double spin = (due - now.angular - det(now.center, now.linear)) / now.inertia;
  turn(*system_, part.cubes, {now.center, Vec2::Zero(), spin}, state);
}

/// Returns what a component has too much, J.
double StepLook::set_energy(const StepComponent& part,
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
  std::vector<Vec2> normals = part.held_along;
  const auto scale = [&](const RigidMotion& kept) {
    return scale_to_energy(*system_, part.cubes, kept, goal, most_scaled_up, state);
  };
  const auto kept = [&] { return kept_motion(momentum_of(*system_, state, part.cubes), normals); };
  double missing = scale(kept());
  if (system_->rubs && !normals.empty()) {
    // Fixed bodies that rub take momentum along their sides, too.
    missing = scale(RigidMotion{});
  } else if (!system_->gravity.isZero(0.0)) {
    // A blow that was taken back has lifted cubes without the momentum that leads there, or lowered them.
    normals.push_back(-system_->gravity.normalized());
    missing = scale(kept());
  }
  return std::max(0.0, -missing);
}

/// Cubes that pushed nothing in the step, and that a look moved from where they flew.
std::vector<int> StepLook::flying(const StepRecord& record,
                                  const State& flown,
                                  const State& state) const {
  std::vector<char> pushed(system_->count(), 0);
  for (const StepComponent& part : record.components) {
    for (const int cube : part.cubes)
      pushed[cube] = 1;
  }
  std::vector<int> cubes;
  for (int cube = 0; cube < system_->cubes; ++cube) {
    if (pushed[cube] == 0 && flown[cube].position != state[cube].position) cubes.push_back(cube);
  }
  return cubes;
}

State StepLook::at(
    const State& from, const State& to, double h, double share, const StepRecord& record) {
  State state = between(from, to, h, share, record);
  set_velocities(from, to, h, share, record, state);
  for (const StepComponent& part : record.components)
    turn_on(part, from, share * h, state);
  const State uncleaned = state;
  removal_.begin(from, h);
  Bookkeeping aside;
  const std::vector<Contact> cleaned = removal_.clean_up(state, aside);
  const bool pushed_out = is_pushed_out(*system_, uncleaned, state);
  if (pushed_out) state = uncleaned;
  if (pushed_out || removal_.left() > overlap_share) removal_.retreat(state);
  keep_turning(*system_, cleaned, uncleaned, state);
  double too_much = 0.0;
  for (const StepComponent& part : record.components)
    too_much += set_energy(part, from, to, share, state);
  for (const int cube : flying(record, uncleaned, state)) {
    const std::array<int, 1> alone{cube};
    const double start = energy_of(*system_, from, alone);
    const double goal = start + share * (energy_of(*system_, to, alone) - start);
    const double missing =
        scale_to_energy(*system_, alone, RigidMotion{}, goal, most_scaled_up, state);
    too_much += std::max(0.0, -missing);
  }
  pay(*system_, record.components, too_much, state);
  return state;
}

}  // namespace wuerfel
