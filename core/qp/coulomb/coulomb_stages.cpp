#include "core/qp/coulomb/coulomb_stages.h"

#include <algorithm>
#include <cmath>

#include "core/qp/residual_meter.h"

namespace wuerfel {
namespace {

constexpr double usual_delta = 1e-8;
constexpr double path_delta = 1e-6;  ///< of paths: K keeps its digits without pivoting
constexpr double least_path_delta = 1e-12;
constexpr double convex_tolerance = 1e-12;
constexpr double interior_goal = 1e-7;  ///< where pairs vanish together no more is to be had
constexpr int most_hopeless_steps = 2;  ///< of newton without compliance
constexpr double crossing_goal = 1e-6;  ///< likewise, where damping leaves rows behind
constexpr double large_delta = 1e-4;    ///< of settling at first
constexpr int settling_factorisations = 100;
constexpr int near_crossings = 100;  ///< of paths that settle, at most, and so many more for a unit
constexpr int crossings_per_near_unit = 4;
constexpr int most_near_crossings = 6000;
constexpr double most_leap_force =
    1e4;  ///< by which a step changes forces where nothing resists, in weights
constexpr double short_margin = 1e-6;
constexpr int most_short_crossings = 50;
constexpr int most_crossed_units = 200;  ///< beyond them it costs as much as an interior step
constexpr int crossings_per_contact = 12;
constexpr int most_crossings = 3000;
constexpr int most_proximal_steps = 8;
constexpr double jamming_force = 1e6;  ///< in weights

}  // namespace

CoulombStages::CoulombStages(const CoulombSettings& settings)
    : settings_(settings), convex_(convex_tolerance) {}

void CoulombStages::prepare(const FrictionProgram& friction) {
  scales_ = judge_.measure_scales(friction.program);
  form_.prepare(friction, scales_);
  solvable = true;
}

void CoulombStages::forget() {
  convex_.forget();
  form_.forget();
}

ContactMode CoulombStages::first_mode(const ContactUnit& unit) {
  if (unit.tangent < 0) return ContactMode::closed;
  return unit.slides != 0 ? slip_mode(unit.slides) : ContactMode::stick;
}

/// A quick look before the judge's: whether rows in force are where they should be.
bool CoulombStages::rows_hold() const {
  for (int i = 0; i < form_.count(); ++i) {
    const double missed = std::abs(point.rest[i].n) * form_.units()[i].per_velocity.n;
    if (modes[i] != ContactMode::open && missed > settings_.tolerance) return false;
  }
  return true;
}

bool CoulombStages::certificate(const FrictionProgram& friction, CoulombResult& result) {
  point.recompute(form_);
  return rows_hold() && judge_point(friction, CoulombStage::certificate, result);
}

ModeNewtonEffort CoulombStages::newton_effort(double delta, int most_factorisations) const {
  return {.delta = delta,
          .least_delta = usual_delta,
          .most_factorisations = most_factorisations,
          .most_force = most_leap_force * scales_.weight};
}

bool CoulombStages::newton(const FrictionProgram& friction,
                           int most_factorisations,
                           CoulombResult& result) {
  ModeNewtonEffort effort = newton_effort(usual_delta, most_factorisations);
  effort.most_no_better = most_hopeless_steps;
  const ModeNewtonOutcome outcome = mode_newton_.run(form_, modes, point, effort);
  result.factorisations += outcome.factorisations;
  return outcome.settled && judge_point(friction, CoulombStage::newton, result);
}

/// Newton's method from the point and its modes, with compliance that shrinks from `delta` on.
bool CoulombStages::harden(const FrictionProgram& friction,
                           double delta,
                           CoulombStage stage,
                           CoulombResult& result) {
  const ModeNewtonOutcome outcome =
      mode_newton_.run(form_, modes, point, newton_effort(delta, settling_factorisations));
  result.factorisations += outcome.factorisations;
  return judge_point(friction, stage, result);
}

void CoulombStages::take(const std::vector<double>& multiplier) {
  for (int i = 0; i < form_.count(); ++i) {
    const ContactUnit& unit = form_.units()[i];
    point.l[i] = {multiplier[unit.normal], unit.tangent >= 0 ? multiplier[unit.tangent] : 0.0};
    clamp_to_cone(unit, point.l[i]);
  }
  cone_ = point.l;
  point.recompute(form_);
  find_modes();
}

/// The modes that the forces of the point show.
void CoulombStages::find_modes() {
  const double force = largest_normal_force(form_, point.l);
  for (int i = 0; i < form_.count(); ++i) {
    const ContactUnit& unit = form_.units()[i];
    const Pair& l = point.l[i];
    modes[i] = first_mode(unit);
    if (unit.equality) continue;
    if (l.n * unit.norm.n <= 1e-10 * force) {
      modes[i] = ContactMode::open;
    } else if (unit.tangent >= 0 && unit.slides == 0
               && std::abs(l.t) > (1.0 - 1e-9) * unit.mu * l.n) {
      modes[i] = slip_mode(-l.t);
    }
  }
}

/// From what is remembered, where few contacts have changed.
bool CoulombStages::follow_shortly(const FrictionProgram& friction, CoulombResult& result) {
  if (form_.count() > most_crossed_units) return false;
  const std::vector<Pair> centre = point.l;
  const ModePathOutcome outcome = mode_path_.run(
      form_, modes, point, centre, 0,
      {.delta = path_delta, .most_crossings = most_short_crossings, .margin = short_margin});
  result.crossings += outcome.crossings;
  return outcome.arrived && harden(friction, large_delta, CoulombStage::newton, result);
}

bool CoulombStages::relax(const FrictionProgram& friction, CoulombResult& result) {
  const QpStatus status = convex_.solve(friction);
  result.factorisations += convex_.iterations();
  if (status != QpStatus::optimal && status != QpStatus::inaccurate) return false;
  take(convex_.multiplier());
  form_.read(point.l, multiplier_);
  cone_ = point.l;
  x_ = convex_.x();
  if (accept(friction, CoulombStage::convex, result)) return true;
  const std::vector<ContactMode> kept_modes = modes;
  const ContactPoint kept_point = point;
  const ModeNewtonOutcome outcome =
      mode_newton_.run(form_, modes, point, newton_effort(usual_delta, 5));
  result.factorisations += outcome.factorisations;
  if (outcome.settled && judge_point(friction, CoulombStage::convex, result)) return true;
  modes = kept_modes;
  point = kept_point;
  return false;
}

bool CoulombStages::interior(const FrictionProgram& friction,
                             double spread,
                             std::uint64_t seed,
                             Folds folds,
                             CoulombResult& result) {
  const double goal = folds == Folds::cross ? crossing_goal : interior_goal;
  const ConeInteriorOutcome outcome = cone_interior_.run(
      form_, scales_.weight, {.goal = goal, .spread = spread, .seed = seed, .folds = folds}, point);
  result.factorisations += outcome.factorisations;
  find_modes();
  if (judge_point(friction, CoulombStage::interior, result)) return true;
  if (outcome.worst < worth_settling) return settle(friction, CoulombStage::interior, result);
  return solvable && approach(friction, soft_delta, CoulombStage::interior, result);
}

bool CoulombStages::follow(const FrictionProgram& friction,
                           PathStart start,
                           std::uint64_t seed,
                           Pivoting pivoting,
                           CoulombResult& result) {
  const CoulombStage stage = start == PathStart::open ? CoulombStage::lemke : CoulombStage::path;
  ModePathEffort effort{
      .delta = pivoting == Pivoting::none ? path_delta : usual_delta,
      .pivoting = pivoting,
      .most_crossings = std::min(100 + crossings_per_contact * form_.count(), most_crossings)};
  std::vector<Pair> centre(point.l.size(), Pair{});
  for (int k = 0; k < most_proximal_steps; ++k) {
    const ModePathOutcome outcome =
        start == PathStart::open && k == 0
            ? mode_path_.run_from_open(form_, modes, point, centre, seed, effort)
            : mode_path_.run(form_, modes, point, centre, seed + k, effort);
    effort.delta = std::max(0.01 * effort.delta, least_path_delta);
    effort.most_crossings -= outcome.crossings;
    result.crossings += outcome.crossings;
    if (!outcome.arrived) return false;
    if (judge_point(friction, stage, result)) return true;
    if (!std::isfinite(point.y.front().v[0])) return false;
    if (settle(friction, stage, result)) return true;
    centre = point.l;
  }
  return false;
}

/// From a point that is nearly right to one that is: by Newton's method, and where that goes round in circles by paths.
bool CoulombStages::settle(const FrictionProgram& friction,
                           CoulombStage stage,
                           CoulombResult& result) {
  const std::vector<ContactMode> kept_modes = modes;
  const ContactPoint kept_point = point;
  bool settled = harden(friction, large_delta, stage, result);
  if (!settled) {
    modes = kept_modes;
    point = kept_point;
    settled = approach(friction, large_delta, stage, result);
  }
  if (!settled) {
    modes = kept_modes;
    point = kept_point;
  }
  return settled;
}

bool CoulombStages::approach(const FrictionProgram& friction,
                             double delta,
                             CoulombStage stage,
                             CoulombResult& result) {
  proximal_path_.begin(
      point, {.delta = delta,
              .most_crossings = std::min(near_crossings + crossings_per_near_unit * form_.count(),
                                         most_near_crossings),
              .most_force = most_leap_force * scales_.weight});
  bool right = false;
  while (!right && proximal_path_.step(form_, modes, point))
    right = judge_point(friction, stage, result);
  result.crossings += proximal_path_.crossings();
  return right;
}

bool CoulombStages::judge_point(const FrictionProgram& friction,
                                CoulombStage stage,
                                CoulombResult& result) {
  cone_ = point.l;
  for (int i = 0; i < form_.count(); ++i)
    clamp_to_cone(form_.units()[i], cone_[i]);
  form_.read(friction.program, point.y, x_);
  form_.read(cone_, multiplier_);
  return accept(friction, stage, result);
}

/// Keeps x and multiplier if they are better than the result; true if they are good enough.
bool CoulombStages::accept(const FrictionProgram& friction,
                           CoulombStage stage,
                           CoulombResult& result) {
  const CoulombResidual residual = judge_.measure(friction, x_, multiplier_);
  if (residual.worst() < result.residual.worst() || result.x.empty()) {
    result.residual = residual;
    result.x = x_;
    result.multiplier = multiplier_;
    result.stage = stage;
  }
  return residual.worst() <= settings_.tolerance;
}

/// Forces beyond everything: the effective inverse mass of what slips has all but vanished.
bool CoulombStages::jams(const FrictionProgram& friction, const CoulombResult& result) const {
  const auto beyond = [&](const FrictionContact& c) {
    const double force = result.multiplier[c.normal] * scales_.row_norm[c.normal];
    return force > jamming_force * scales_.weight;
  };
  return std::any_of(friction.contacts.begin(), friction.contacts.end(), beyond);
}

}  // namespace wuerfel
