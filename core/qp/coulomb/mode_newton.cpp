#include "core/qp/coulomb/mode_newton.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

constexpr double noise_share = 1e-13;
constexpr double row_goal = 1e-12;   ///< what rows in force may miss, of the largest velocity
constexpr int most_passes = 100;     ///< back-solves per factorisation
constexpr double slow_share = 0.5;   ///< of what rows miss that a proximal step leaves
constexpr double delta_fall = 0.1;   ///< by which compliance shrinks then
constexpr double least_rate = 1e-9;  ///< of forces, of the largest one: smaller ones are rounding
/// Proximal steps that get no nearer end here: what is left may be rounding.
constexpr double near_goal = 2e-11;
constexpr double stalled_share = 0.9;
constexpr int most_stalled = 3;
constexpr int few_modes = 3;  ///< that change are no reason to give up

/// What the forces and velocities of a unit ask for.
ContactMode wanted_mode(const ContactUnit& unit,
                        ContactMode mode,
                        const Pair& l,
                        const Pair& rest,
                        double noise,
                        double no_force) {
  const double nothing_n = noise / unit.per_velocity.n;
  const bool rubs = unit.tangent >= 0;
  if (mode == ContactMode::open) {
    if (rest.n <= nothing_n) return mode;
    if (!rubs) return ContactMode::closed;
    if (unit.slides != 0) return slip_mode(unit.slides);
    if (std::abs(rest.t) <= unit.mu * rest.n) return ContactMode::stick;
    return slip_mode(-rest.t);
  }
  if (l.n < -no_force / unit.norm.n && !unit.equality) return ContactMode::open;
  if (mode == ContactMode::stick) {
    if (std::abs(l.t) > unit.mu * l.n + no_force / unit.norm.t) return slip_mode(-l.t);
  } else if (rubs && unit.slides == 0) {
    if (-rest.t * slip_sign(mode) < -noise / unit.per_velocity.t) return ContactMode::stick;
  }
  return mode;
}

void follow_modes(const ContactForm& form,
                  const std::vector<ContactMode>& modes,
                  ContactPoint& point) {
  for (int i = 0; i < form.count(); ++i)
    follow_mode(form.units()[i], modes[i], point.l[i]);
}

}  // namespace

int revise_modes(const ContactForm& form,
                 const std::vector<Pair>& l,
                 const std::vector<Pair>& rest,
                 double noise,
                 std::vector<ContactMode>& modes) {
  const double force = largest_force(form, l);
  int moved = 0;
  for (int i = 0; i < form.count(); ++i) {
    const ContactMode wanted =
        wanted_mode(form.units()[i], modes[i], l[i], rest[i], noise, noise * force);
    if (wanted == modes[i]) continue;
    modes[i] = wanted;
    ++moved;
  }
  return moved;
}

/// -(u + d (l - c)) of every unit.
void ModeNewton::find_missing(const ContactForm& form, const ContactPoint& point) {
  missing_.resize(point.l.size());
  for (int i = 0; i < form.count(); ++i) {
    const Pair& d = form.units()[i].compliance;
    missing_[i] = {point.rest[i].n - delta_ * d.n * (point.l[i].n - centre_[i].n),
                   point.rest[i].t - delta_ * d.t * (point.l[i].t - centre_[i].t)};
  }
}

/// G' l - y of the point; whether it is no more than rounding.
bool ModeNewton::find_unbalance(const ContactForm& form, const ContactPoint& point) {
  unbalance_.resize(point.y.size());
  form.apply_transposed(point.l.data(), unbalance_.data());
  double most = 0.0;
  double size = 0.0;
  for (std::size_t b = 0; b < unbalance_.size(); ++b) {
    for (int c = 0; c < 3; ++c) {
      unbalance_[b].v[c] -= point.y[b].v[c];
      most = std::max(most, std::abs(unbalance_[b].v[c]));
      size = std::max(size, std::abs(point.y[b].v[c]));
    }
  }
  return most <= noise_share * size;
}

/// To the solution of the piece, but for rounding.
void ModeNewton::step(const ContactForm& form, ContactPoint& point) {
  find_unbalance(form, point);
  find_missing(form, point);
  system_.solve(form, missing_, unbalance_, rough_balance);
  system_.move(1.0, point);
}

/// What compliance has left of a point that misses so little is rounding.
void ModeNewton::finish(const ContactForm& form, double missed, ContactPoint& point) {
  if (missed > noise_share || !find_unbalance(form, point)) step(form, point);
}

/// Goes on along the last step, which those to come would repeat, `most` times at most: to the first contact whose force
/// comes to the edge of its cone. Rows that contradict one another (contacts in a loop whose gaps differ by 1e-11) drive forces
/// along a state of self-stress for ever, until a contact gives way.
ModeNewton::End ModeNewton::extrapolate(const ContactForm& form,
                                        std::vector<ContactMode>& modes,
                                        ContactPoint& point,
                                        double most,
                                        double most_force) {
  const std::vector<Pair>& dl = system_.dl();
  const double largest = largest_force(form, dl);
  const auto rate_of = [&](double rate, double norm) {
    return std::abs(rate) * norm > least_rate * largest ? rate : 0.0;
  };
  const double farthest = most_force / largest;
  Crossing first{.step = std::min(most, farthest)};
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    if (unit.equality || modes[i] == ContactMode::open) continue;
    const Pair rate = {rate_of(dl[i].n, unit.norm.n), rate_of(dl[i].t, unit.norm.t)};
    first.meet_cone(unit, modes[i], point.l[i], rate, i);
  }
  if (first.step == farthest) return End::stuck;
  system_.move(first.step, point);
  centre_ = point.l;
  if (first.unit < 0) return End::slow;
  modes[first.unit] = first.to;
  return End::moved;
}

/// Until modes ask to be changed, rows in force are within the goal, or it gets on too slowly.
ModeNewton::ProximalSteps ModeNewton::take_proximal_steps(const ContactForm& form,
                                                          std::vector<ContactMode>& modes,
                                                          ContactPoint& point,
                                                          const ModeNewtonEffort& effort) {
  double former = unbounded;
  int stalled = 0;
  for (int pass = 0; pass < most_passes; ++pass) {
    step(form, point);
    find_missing(form, point);
    const int revised = revise_modes(form, point.l, missing_, noise_share, modes);
    if (revised > 0) return {End::moved, revised};
    centre_ = point.l;
    search_ = {};
    const double missed = missed_by(form, modes, point);
    stalled = missed < stalled_share * former ? 0 : stalled + 1;
    if (missed <= row_goal || (missed <= near_goal && stalled == most_stalled)) {
      finish(form, missed, point);
      return {End::settled};
    }
    if (missed < slow_share * former || former == unbounded) {
      former = missed;
      continue;
    }
    if (delta_ > effort.least_delta) return {End::slow};
    const double left = missed / former;
    const double most = left < 1.0 ? left / (1.0 - left) : unbounded;
    const End end = extrapolate(form, modes, point, most, effort.most_force);
    if (end != End::slow) return {end, 1};
    former = unbounded;
  }
  return {End::stuck};
}

/// Whether Newton's method approaches a solution since modes were confirmed. Where it was at these modes before it would
/// repeat itself.
bool ModeNewton::gets_on(const std::vector<ContactMode>& modes, int revised, int most) {
  Search& s = search_;
  if (std::ranges::find(s.visited, modes) != s.visited.end()) return false;
  s.visited.push_back(modes);
  s.no_better = revised < s.fewest ? 0 : s.no_better + 1;
  s.fewest = std::min(s.fewest, revised);
  return s.no_better < most || revised <= few_modes;
}

ModeNewtonOutcome ModeNewton::run(ContactForm& form,
                                  std::vector<ContactMode>& modes,
                                  ContactPoint& point,
                                  const ModeNewtonEffort& effort) {
  ModeNewtonOutcome outcome;
  delta_ = effort.delta;
  search_ = {};
  follow_modes(form, modes, point);
  centre_ = point.l;
  while (outcome.factorisations < effort.most_factorisations) {
    ++outcome.factorisations;
    if (!system_.factorise(form, modes, delta_, Pivoting::none)) return outcome;
    const auto [end, revised] = take_proximal_steps(form, modes, point, effort);
    outcome.settled = end == End::settled;
    if (outcome.settled || end == End::stuck) return outcome;
    if (end == End::slow) delta_ = std::max(delta_fall * delta_, effort.least_delta);
    if (end == End::moved && !gets_on(modes, revised, effort.most_no_better)) return outcome;
    follow_modes(form, modes, point);
  }
  return outcome;
}

}  // namespace wuerfel
