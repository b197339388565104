#include "core/qp/coulomb/cone_interior_point.h"

#include <algorithm>
#include <cmath>

#include "core/qp/block/quad_vector.h"
#include "core/qp/coulomb/dice.h"
#include "core/qp/refinement.h"

namespace wuerfel {
namespace {

constexpr int most_interior_steps = 250;
constexpr double short_step = 0.1;   ///< below it the corrector is given up
constexpr double stuck_step = 0.02;  ///< four of these in a row end it
constexpr int most_stuck_steps = 4;
/// A point as good as this that is followed by so many worse ones is the best: K has lost its digits.
constexpr double nearly_there = 1e-5;
constexpr int most_worse_steps = 3;
/// Damping of steps across folds, as compliance of K alone: it grows where they are short or det K < 0, and shrinks again.
constexpr double least_damping = 1e-8;
constexpr double first_damping = 1e-4;
constexpr double most_damping = 1e-3;       ///< of short steps
constexpr double most_damping_back = 1e-1;  ///< where det K < 0
constexpr double damping_change = 10.0;
constexpr double damped_step = 0.3;
constexpr double undamped_step = 0.5;

/// All products equal, or as their weights ask.
void start(const ContactForm& form, const ConeInteriorEffort& effort, ConeIterate& at) {
  Dice dice(effort.seed);
  at.point.reset(form);
  at.pairs.assign(form.count(), ConePairs{});
  double size = 0.0;
  for (const ContactUnit& unit : form.units()) {
    size = std::max(size, std::abs(unit.h.n) / std::sqrt(unit.square.n));
    if (unit.tangent >= 0) size = std::max(size, std::abs(unit.h.t) / std::sqrt(unit.square.t));
  }
  if (size == 0.0) size = 1.0;
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    ConePairs& p = at.pairs[i];
    if (unit.equality) continue;
    const double norm = std::sqrt(unit.square.n);
    p.count = unit.tangent >= 0 && unit.slides == 0 ? 3 : 1;
    p.force[0] = size / norm;
    for (int k = 1; k < p.count; ++k)
      p.force[k] = unit.mu * p.force[0];
    for (int k = 0; k < p.count; ++k) {
      if (effort.spread > 0.0) p.weight[k] = dice.next_factor(effort.spread);
      p.slack[k] = p.weight[k] * size * size / p.force[k];
    }
    at.point.l[i].n = p.force[0];
    if (unit.slides != 0) at.point.l[i].t = -unit.slides * unit.mu * p.force[0];
  }
  at.point.recompute(form);
}

/// C^-1 of every unit.
void find_weights(const ContactForm& form,
                  const std::vector<ConePairs>& pairs,
                  double delta,
                  std::vector<ContactForm::Weight>& weight) {
  weight.resize(pairs.size());
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    const ConePairs& p = pairs[i];
    ContactForm::Weight w;
    w.nn = 1.0 / (delta * unit.compliance.n + p.slack[0] / p.force[0]);
    if (p.count == 3) {
      const double A = p.slack[1] / p.force[1];
      const double B = p.slack[2] / p.force[2];
      w.tt = 1.0 / (delta * unit.compliance.t + A + B);
      w.tn = -unit.mu * (B - A) * w.nn * w.tt;
    } else if (unit.slides != 0) {
      w.tn = -unit.slides * unit.mu * w.nn;
    }
    weight[i] = w;
  }
}

/// dl and G dy of dy, and what is missed of the equations.
void find_dl(const ContactForm& form,
             const ContactPoint& at,
             ConeSystem& system,
             ContactStep& step) {
  form.respond(system.weight, system.right, &at.l, step, system.missed.data());
  for (std::size_t b = 0; b < step.dy.size(); ++b) {
    for (int c = 0; c < 3; ++c)
      system.missed[b].v[c] -= at.y[b].v[c] + step.dy[b].v[c];
  }
}

/// The system solved and refined.
void solve(const ContactForm& form, const ContactPoint& at, ConeSystem& system, ContactStep& step) {
  step.dl.resize(at.l.size());
  step.Gdy.resize(at.l.size());
  step.dy.assign(at.y.size(), Quad{});
  system.missed.resize(at.y.size());
  find_dl(form, at, system, step);
  double former = unbounded;
  for (int round = 0; round <= most_refinements; ++round) {
    form.solve(system.missed.data());
    add(1.0, system.missed, step.dy);
    find_dl(form, at, system, step);
    const double missed = dot(system.missed, system.missed);
    if (missed <= 1e-28 * dot(step.dy, step.dy) || !(missed < 0.25 * former)) break;
    former = missed;
  }
}

/// Newton's direction to products weight * tau less the corrector's terms.
void find_direction(const ContactForm& form,
                    const ConeIterate& at,
                    double tau,
                    ConeSystem& system,
                    ConeDirection& step) {
  system.right.resize(at.pairs.size());
  for (int i = 0; i < form.count(); ++i) {
    const ConePairs& p = at.pairs[i];
    double to[3] = {0.0, 0.0, 0.0};  // what the slacks become where the forces stay
    for (int k = 0; k < p.count; ++k)
      to[k] = (p.weight[k] * tau - system.corrector[i][k]) / p.force[k];
    system.right[i] = {at.point.rest[i].n + to[0], at.point.rest[i].t + to[2] - to[1]};
  }
  solve(form, at.point, system, step.point);
  for (int i = 0; i < form.count(); ++i) {
    const double mu = form.units()[i].mu;
    const Pair& dl = step.point.dl[i];
    const ConePairs& p = at.pairs[i];
    ConePairsStep& d = step.pairs[i];
    d.force[0] = dl.n;
    d.force[1] = mu * dl.n - dl.t;
    d.force[2] = mu * dl.n + dl.t;
    for (int k = 0; k < p.count; ++k) {
      const double product = p.weight[k] * tau - system.corrector[i][k];
      d.slack[k] = (product - p.slack[k] * d.force[k]) / p.force[k] - p.slack[k];
    }
  }
}

/// 1 / the largest force, which is `weight` at least.
double per_largest_force(const ContactForm& form, const ContactPoint& point, double weight) {
  double force = weight;
  for (int i = 0; i < form.count(); ++i)
    force = std::max(force, std::abs(point.l[i].n) * form.units()[i].norm.n);
  return force > 0.0 ? 1.0 / force : 1.0;
}

/// The partners of a pair as shares of the largest force and velocity.
struct Product {
  double force = 0.0;
  double slack = 0.0;
};

Product product_of(const ContactUnit& unit, const ConePairs& p, int k, double per_force) {
  const double norm = k == 0 ? unit.norm.n : unit.norm.t;
  const double per_velocity = k == 0 ? unit.per_velocity.n : unit.per_velocity.t;
  return {p.force[k] * norm * per_force, p.slack[k] * per_velocity};
}

/// The smaller of every pair and what rows miss, forces to the largest force.
double worst_pair(const ContactForm& form, double weight, const ConeIterate& at) {
  const double per_force = per_largest_force(form, at.point, weight);
  double worst = 0.0;
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    const ConePairs& p = at.pairs[i];
    for (int k = 0; k < p.count; ++k) {
      const Product product = product_of(unit, p, k, per_force);
      worst = std::max(worst, std::min(product.force, product.slack));
    }
    const Pair& rest = at.point.rest[i];
    worst = std::max(worst, std::abs(rest.n + p.slack[0]) * unit.per_velocity.n);
    if (p.count == 3) {
      const double t = rest.t + p.slack[2] - p.slack[1];
      worst = std::max(worst, std::abs(t) * unit.per_velocity.t);
    }
  }
  return std::isfinite(worst) ? worst : unbounded;
}

/// The point with every pair's smaller partner put to zero.
void round_off(const ContactForm& form, double weight, const ConeIterate& at, ContactPoint& point) {
  point = at.point;
  const double per_force = per_largest_force(form, at.point, weight);
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    const ConePairs& p = at.pairs[i];
    if (p.count == 0) continue;
    const auto is_force = [&](int k) {
      const Product product = product_of(unit, p, k, per_force);
      return product.force >= product.slack;
    };
    Pair& l = point.l[i];
    if (!is_force(0)) l = {};
    if (p.count == 3 && l.n > 0.0 && !is_force(1)) l.t = unit.mu * l.n;
    if (p.count == 3 && l.n > 0.0 && !is_force(2)) l.t = -unit.mu * l.n;
    clamp_to_cone(unit, l);
  }
}

/// Predictor and corrector; beyond a fold, where det K < 0, tau has to grow. Returns the length of the step.
double choose_direction(const ContactForm& form,
                        const ConeIterate& at,
                        Folds folds,
                        ConeSystem& system,
                        ConeDirection& step) {
  const double tau = mean_product(at, step, 0.0);
  system.corrector.assign(at.pairs.size(), {});
  if (form.sign() < 0 && folds == Folds::go_back) {
    find_direction(form, at, 2.0 * tau, system, step);
    return step_length(at, step);
  }
  find_direction(form, at, 0.0, system, step);
  const double ratio = tau > 0.0 ? mean_product(at, step, step_length(at, step)) / tau : 0.0;
  for (std::size_t i = 0; i < at.pairs.size(); ++i) {
    for (int k = 0; k < at.pairs[i].count; ++k)
      system.corrector[i][k] = step.pairs[i].force[k] * step.pairs[i].slack[k];
  }
  find_direction(form, at, std::clamp(ratio * ratio * ratio, 0.0, 1.0) * tau, system, step);
  const double length = step_length(at, step);
  if (length >= short_step) return length;
  system.corrector.assign(at.pairs.size(), {});
  find_direction(form, at, 0.9 * tau, system, step);
  return step_length(at, step);
}

/// Of steps across folds.
class Damping {
 public:
  explicit Damping(const ConeInteriorEffort& effort) : crosses_(effort.folds == Folds::cross) {}

  [[nodiscard]] double delta() const { return delta_; }
  /// Grows where det K has this sign; false where it is to stay as it is.
  bool grow(int sign) {
    if (!crosses_ || sign >= 0 || delta_ >= most_damping_back) return false;
    grow_to(most_damping_back);
    return true;
  }
  /// Takes note of the length of a step.
  void follow(double step) {
    if (crosses_ && step < damped_step) grow_to(most_damping);
    if (crosses_ && step > undamped_step) delta_ = std::max(delta_ / damping_change, least_damping);
  }

 private:
  void grow_to(double most) { delta_ = std::clamp(damping_change * delta_, first_damping, most); }

  bool crosses_;
  double delta_ = least_damping;
};

}  // namespace

ConeInteriorOutcome ConeInteriorPoint::run(ContactForm& form,
                                           double weight,
                                           const ConeInteriorEffort& effort,
                                           ContactPoint& point) {
  ConeInteriorOutcome outcome;
  start(form, effort, at_);
  step_.pairs.assign(at_.pairs.size(), {});
  Damping damping(effort);
  int stuck = 0;
  int worse = 0;
  while (outcome.factorisations < most_interior_steps && stuck < most_stuck_steps
         && worse < most_worse_steps) {
    find_weights(form, at_.pairs, damping.delta(), system_.weight);
    ++outcome.factorisations;
    if (!form.factorise(system_.weight)) break;
    if (damping.grow(form.sign())) continue;
    double step = choose_direction(form, at_, effort.folds, system_, step_);
    damping.follow(step);
    if (step < short_step) step = step_length_of_most(at_, step_);
    move(step, step_, at_);
    const double worst = worst_pair(form, weight, at_);
    worse = worst >= outcome.worst && outcome.worst < nearly_there ? worse + 1 : 0;
    if (worst < outcome.worst) {
      outcome.worst = worst;
      round_off(form, weight, at_, point);
    }
    if (worst <= effort.goal || worst == unbounded) break;
    stuck = step < stuck_step ? stuck + 1 : 0;
  }
  return outcome;
}

}  // namespace wuerfel
