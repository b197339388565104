#include "core/qp/coulomb/mode_newton.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

constexpr double noise_share = 1e-13;
constexpr int most_passes = 12;  ///< back-solves per factorisation

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

}  // namespace

int revise_modes(const ContactForm& form,
                 const ContactPoint& point,
                 double noise,
                 std::vector<ContactMode>& modes) {
  double force = 0.0;
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    force = std::max(
        {force, std::abs(point.l[i].n) * unit.norm.n, std::abs(point.l[i].t) * unit.norm.t});
  }
  int moved = 0;
  for (int i = 0; i < form.count(); ++i) {
    const ContactMode wanted =
        wanted_mode(form.units()[i], modes[i], point.l[i], point.rest[i], noise, noise * force);
    if (wanted == modes[i]) continue;
    modes[i] = wanted;
    ++moved;
  }
  return moved;
}

/// One solve of the piece; returns what rows in force missed before it.
double ModeNewton::step(const ContactForm& form,
                        const std::vector<ContactMode>& modes,
                        ContactPoint& point) {
  unbalance_.resize(point.y.size());
  form.apply_transposed(point.l.data(), unbalance_.data());
  for (std::size_t b = 0; b < unbalance_.size(); ++b) {
    for (int c = 0; c < 3; ++c)
      unbalance_[b].v[c] -= point.y[b].v[c];
  }
  system_.solve(form, point.rest, unbalance_);
  double missed = 0.0;
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    point.l[i].n += system_.dl()[i].n;
    point.l[i].t += system_.dl()[i].t;
    point.rest[i].n -= system_.Gdy()[i].n;
    point.rest[i].t -= system_.Gdy()[i].t;
    if (modes[i] != ContactMode::open)
      missed = std::max(missed, std::abs(point.rest[i].n) * unit.per_velocity.n);
    if (modes[i] == ContactMode::stick)
      missed = std::max(missed, std::abs(point.rest[i].t) * unit.per_velocity.t);
  }
  for (std::size_t b = 0; b < point.y.size(); ++b) {
    for (int c = 0; c < 3; ++c)
      point.y[b].v[c] += system_.dy()[b].v[c];
  }
  return missed;
}

ModeNewtonOutcome ModeNewton::run(ContactForm& form,
                                  std::vector<ContactMode>& modes,
                                  ContactPoint& point,
                                  const ModeNewtonEffort& effort) {
  ModeNewtonOutcome outcome;
  while (outcome.factorisations < effort.most_factorisations) {
    for (int i = 0; i < form.count(); ++i)
      follow_mode(form.units()[i], modes[i], point.l[i]);
    ++outcome.factorisations;
    if (!system_.factorise(form, modes, effort.delta, effort.pivoting)) return outcome;
    bool same = true;
    for (int pass = 0; same && pass < most_passes; ++pass) {
      const double missed = step(form, modes, point);
      same = revise_modes(form, point, noise_share, modes) == 0;
      outcome.settled = same && missed <= effort.goal;
      if (outcome.settled) return outcome;
    }
    if (same) return outcome;
  }
  return outcome;
}

}  // namespace wuerfel
