#include "core/qp/coulomb/mode_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/qp/block/quad_vector.h"
#include "core/qp/coulomb/dice.h"

namespace wuerfel {
namespace {

/// Share of dy by which tangents may be out of balance: `correct` takes it away.
constexpr double tangent_balance = 1e-8;

class FirstPiece {
 public:
  explicit FirstPiece(std::vector<ContactMode> modes) : modes_(std::move(modes)) {}
  /// Takes note of the new mode of a unit; true where all modes are those of the first piece again.
  bool is_back(int unit, ContactMode from, ContactMode to) {
    if (from == modes_[unit]) ++apart_;
    if (to == modes_[unit]) --apart_;
    return apart_ == 0;
  }

 private:
  std::vector<ContactMode> modes_;
  int apart_ = 0;  ///< units whose modes differ
};

}  // namespace

ModePathOutcome ModePath::run(ContactForm& form,
                              std::vector<ContactMode>& modes,
                              ContactPoint& point,
                              const std::vector<Pair>& centre,
                              std::uint64_t seed,
                              const ModePathEffort& effort) {
  const double margin = effort.margin;
  const double velocity_margin = effort.velocity_margin;
  Dice dice(seed);
  delta_ = effort.delta;
  centre_ = centre;
  t_ = 1.0;
  const double force = largest_normal_force(form, point.l);
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    Pair& l = point.l[i];
    if (modes[i] != ContactMode::open && !unit.equality)
      l.n = std::max(l.n, margin * dice.next() * force / unit.norm.n);
    follow_mode(unit, modes[i], l);
    if (modes[i] == ContactMode::stick) l.t *= 1.0 - margin * dice.next();
  }
  point.recompute(form);
  r_.assign(point.l.size(), Pair{});
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    const Pair e = slack(form, point, i);
    const double s = slip_sign(modes[i]);
    r_[i] = e;
    if (modes[i] == ContactMode::open) {
      r_[i].n = e.n - std::max(e.n, velocity_margin * dice.next() / unit.per_velocity.n);
      r_[i].t = 0.0;
    } else if (s != 0.0 && unit.slides == 0) {
      r_[i].t = e.t - s * std::max(s * e.t, velocity_margin * dice.next() / unit.per_velocity.t);
    }
  }
  return follow(form, modes, point, effort);
}

ModePathOutcome ModePath::run_from_open(ContactForm& form,
                                        std::vector<ContactMode>& modes,
                                        ContactPoint& point,
                                        const std::vector<Pair>& centre,
                                        std::uint64_t seed,
                                        const ModePathEffort& effort) {
  Dice dice(seed);
  delta_ = effort.delta;
  centre_ = centre;
  point.reset(form);
  r_.assign(point.l.size(), Pair{});
  t_ = 1.0;
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    modes[i] = unit.equality ? ContactMode::closed : ContactMode::open;
    if (unit.equality) continue;
    r_[i].n = -(1.0 + dice.next()) / unit.per_velocity.n;
    if (unit.tangent >= 0) r_[i].t = 1e-3 * (dice.next() - 0.5) / unit.per_velocity.t;
  }
  // Rods first, then as far away as it takes to open everything.
  unbalance_.assign(point.y.size(), Quad{});
  if (!system_.factorise(form, modes, delta_, effort.pivoting)) return {};
  correct(form, modes, point);
  for (int i = 0; i < form.count(); ++i) {
    if (modes[i] != ContactMode::open) continue;
    t_ = std::max(t_, 2.0 * slack(form, point, i).n / r_[i].n);
  }
  return follow(form, modes, point, effort);
}

/// u + d (l - c) of a unit, before t r is taken off.
Pair ModePath::slack(const ContactForm& form, const ContactPoint& point, int i) const {
  const ContactUnit& unit = form.units()[i];
  const Pair& l = point.l[i];
  return {-point.rest[i].n + delta_ * unit.compliance.n * (l.n - centre_[i].n),
          -point.rest[i].t + delta_ * unit.compliance.t * (l.t - centre_[i].t)};
}

/// Its rate while t falls by one.
Pair ModePath::slack_rate(const ContactForm& form, int i) const {
  const ContactUnit& unit = form.units()[i];
  return {system_.Gdy()[i].n + delta_ * unit.compliance.n * system_.dl()[i].n + r_[i].n,
          system_.Gdy()[i].t + delta_ * unit.compliance.t * system_.dl()[i].t + r_[i].t};
}

/// Takes away what rounding left between the point and the path.
void ModePath::correct(const ContactForm& form,
                       const std::vector<ContactMode>& modes,
                       ContactPoint& point) {
  rhs_.assign(r_.size(), Pair{});
  for (int i = 0; i < form.count(); ++i) {
    if (modes[i] == ContactMode::open) continue;
    const Pair e = slack(form, point, i);
    rhs_[i] = {t_ * r_[i].n - e.n, t_ * r_[i].t - e.t};
  }
  unbalance_.resize(point.y.size());
  form.apply_transposed(point.l.data(), unbalance_.data());
  add(-1.0, point.y, unbalance_);
  system_.solve(form, rhs_, unbalance_);
  system_.move(1.0, point);
}

/// Rates of everything while t falls by one.
void ModePath::find_tangent(const ContactForm& form, ContactPoint& point) {
  for (std::size_t i = 0; i < r_.size(); ++i)
    rhs_[i] = {-r_[i].n, -r_[i].t};
  unbalance_.assign(point.y.size(), Quad{});
  system_.solve(form, rhs_, unbalance_, tangent_balance);
}

/// How fast what became free at the last crossing grows while t falls.
double ModePath::entering_rate(const ContactForm& form,
                               ContactMode from,
                               ContactMode to,
                               int i) const {
  const Pair& dl = system_.dl()[i];
  if (to == ContactMode::open) return slack_rate(form, i).n;
  if (from == ContactMode::open) return dl.n;
  if (to == ContactMode::stick) return form.units()[i].mu * dl.n + slip_sign(from) * dl.t;
  return slip_sign(to) * slack_rate(form, i).t;
}

Crossing ModePath::next_crossing(const ContactForm& form,
                                 const std::vector<ContactMode>& modes,
                                 const ContactPoint& point,
                                 double direction) const {
  Crossing first;
  const auto meet = [&](double value, double rate, int unit, ContactMode to) {
    first.meet(value, rate * direction, unit, to);
  };
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    if (unit.equality) continue;
    const ContactMode mode = modes[i];
    const Pair& dl = system_.dl()[i];
    if (mode == ContactMode::open) {
      const Pair rate = slack_rate(form, i);
      const Pair e = slack(form, point, i);
      meet(e.n - t_ * r_[i].n, rate.n, i, ContactMode::closed);
      if (first.unit != i || unit.tangent < 0) continue;
      // The direction of slip is the one where it closes.
      const double ut = e.t - t_ * r_[i].t + direction * first.step * rate.t;
      first.to = slip_mode(unit.slides != 0 ? unit.slides : ut);
      continue;
    }
    first.meet_cone(unit, mode, point.l[i], {direction * dl.n, direction * dl.t}, i);
    const double s = slip_sign(mode);
    if (s != 0.0 && unit.slides == 0) {
      const double ut = slack(form, point, i).t - t_ * r_[i].t;
      meet(s * ut, s * slack_rate(form, i).t, i, ContactMode::stick);
    }
  }
  return first;
}

/// The system and the tangent of the piece that the path has come to by the new mode of `unit`; of the first one: -1.
bool ModePath::enter(ContactForm& form,
                     const std::vector<ContactMode>& modes,
                     const ModePathEffort& effort,
                     int unit,
                     ContactPoint& point) {
  const bool regular = unit < 0 ? system_.factorise(form, modes, delta_, effort.pivoting)
                                : system_.change(form, modes, unit);
  if (!regular) return false;
  if (system_.updated()) {
    system_.solve_again(form, rhs_, unbalance_, unit, tangent_balance);
  } else {
    correct(form, modes, point);
    find_tangent(form, point);
  }
  return true;
}

/// On the last piece.
void ModePath::arrive(const ContactForm& form,
                      const std::vector<ContactMode>& modes,
                      ContactPoint& point) {
  system_.move(t_, point);
  t_ = 0.0;
  if (system_.updated()) correct(form, modes, point);
}

ModePathOutcome ModePath::follow(ContactForm& form,
                                 std::vector<ContactMode>& modes,
                                 ContactPoint& point,
                                 const ModePathEffort& effort) {
  ModePathOutcome outcome;
  double direction = 1.0;  // of -t
  Crossing crossing;
  ContactMode from = ContactMode::open;
  FirstPiece first(modes);
  while (true) {
    if (!enter(form, modes, effort, crossing.unit, point)) return outcome;
    if (crossing.unit >= 0)
      direction = entering_rate(form, from, crossing.to, crossing.unit) >= 0.0 ? 1.0 : -1.0;
    crossing = next_crossing(form, modes, point, direction);
    outcome.arrived = direction > 0.0 && crossing.step >= t_;
    if (outcome.arrived) {
      arrive(form, modes, point);
      return outcome;
    }
    const bool ray = crossing.unit < 0;  // the path goes on for ever
    if (ray || outcome.crossings == effort.most_crossings || t_ > effort.farthest) return outcome;
    ++outcome.crossings;
    system_.move(direction * crossing.step, point);
    t_ -= direction * crossing.step;
    from = modes[crossing.unit];
    modes[crossing.unit] = crossing.to;
    if (first.is_back(crossing.unit, from, crossing.to)) return outcome;
    follow_mode(form.units()[crossing.unit], crossing.to, point.l[crossing.unit]);
  }
}

}  // namespace wuerfel
