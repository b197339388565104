#include "core/time/stepping/step_look.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

/// Where a cube is at `share` of a step of `h` s. What is struck, so that its velocity changes by
/// more than `rough` (m/s), flies on until it is: the instant follows from the way it has come.
BodyState between(const BodyState& from,
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
    const double of_way = 6.0 * s * (1.0 - s) / h;
    const double of_first = (1.0 - s) * (1.0 - 3.0 * s);
    const double of_last = s * (3.0 * s - 2.0);
    state.velocity = of_way * way + of_first * from.velocity + of_last * to.velocity;
    state.spin = of_way * (to.angle - from.angle) + of_first * from.spin + of_last * to.spin;
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
  if (share >= struck) {
    state.velocity = to.velocity;
    state.spin = to.spin;
  }
  return state;
}

}  // namespace

void bring_down(const System& system, double ceiling, State& state) {
  const double excess = energy(system, state) - ceiling;
  if (excess <= 0.0) return;
  const double kinetic = kinetic_energy(system, state);
  const double share = kinetic > excess ? std::sqrt(1.0 - excess / kinetic) : 0.0;
  for (BodyState& s : state) {
    s.velocity *= share;
    s.spin *= share;
  }
}

State StepLook::at(const State& from, const State& to, double h, double share) {
  removal_.begin(from, h);
  const double rough = rough_steps * scales_of(*system_, from).gravity * h;
  State state = from;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const double radius = system_->bodies[i].radius();
    state[i] = between(from[i], to[i], h, share, radius, rough);
  }
  Bookkeeping aside;
  std::vector<Contact> pushing;
  removal_.clean_up(state, pushing, aside);
  if (removal_.left() > overlap_share) removal_.retreat(state);
  bring_down(*system_, std::max(energy(*system_, from), energy(*system_, to)), state);
  return state;
}

}  // namespace wuerfel
