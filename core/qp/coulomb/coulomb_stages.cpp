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
constexpr double near_margin = 1e-9;
constexpr double near_velocity_margin = 1e-4;  ///< times the compliance
constexpr double near_delta_fall = 0.1;
constexpr int near_crossings = 100;  ///< at most, and one more for so many units
constexpr int units_per_near_crossing = 8;
constexpr double leap_delta = 3e-8;  ///< below it K has lost its digits: G' l differs from y
constexpr int most_leaping_steps = 30;
constexpr double hardly_nearer = 0.9;  ///< of what rows miss that a step leaves
constexpr double leap_growth = 10.0;
constexpr double most_leap_force = 1e4;     ///< by which a leap changes forces, in weights
constexpr double most_leap_misses = 100.0;  ///< times what was missed before
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
  double force = 0.0;
  for (int i = 0; i < form_.count(); ++i)
    force = std::max(force, point.l[i].n * form_.units()[i].norm.n);
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
  return outcome.arrived && settle(friction, CoulombStage::newton, result);
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
  return outcome.worst < worth_settling && settle(friction, CoulombStage::interior, result);
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

/// From a point that is nearly right to one that is: by Newton's method, and where that goes round in circles by a path. The
/// second kind of path is dearer than another interior point.
bool CoulombStages::settle(const FrictionProgram& friction,
                           CoulombStage stage,
                           CoulombResult& result) {
  const std::vector<ContactMode> kept_modes = modes;
  const ContactPoint kept_point = point;
  if (harden(friction, large_delta, stage, result)) return true;
  for (const NearSteps steps : {NearSteps::leap, NearSteps::stiffen}) {
    if (steps == NearSteps::stiffen && stage == CoulombStage::interior) break;
    modes = kept_modes;
    point = kept_point;
    if (follow_near(friction, steps, stage, result)) return true;
  }
  modes = kept_modes;
  point = kept_point;
  return false;
}

/// Proximal steps, each by a path that is short: the point is moved by no more than it misses. Where rows contradict one
/// another by that little each moves forces along a state of self-stress by as much. Either compliance is taken away on and
/// on, or, where it is small already and a step hardly got nearer, the next one leaps along it, farther and farther, until
/// rows miss much more than before.
bool CoulombStages::follow_near(const FrictionProgram& friction,
                                NearSteps steps,
                                CoulombStage stage,
                                CoulombResult& result) {
  const bool leaping = steps == NearSteps::leap;
  const double least_delta = leaping ? leap_delta : least_path_delta;
  std::vector<Pair> centre = point.l;
  double leap = 1.0;  // steps at once
  double former = unbounded;
  ModePathEffort effort{.delta = path_delta,
                        .most_crossings = near_crossings + form_.count() / units_per_near_crossing,
                        .margin = near_margin};
  for (int k = 0; k < (leaping ? most_leaping_steps : most_proximal_steps); ++k) {
    effort.velocity_margin = near_velocity_margin * effort.delta;
    const std::vector<Pair> start = point.l;
    const auto seed = static_cast<std::uint64_t>(k);
    const ModePathOutcome outcome = mode_path_.run(form_, modes, point, centre, seed, effort);
    result.crossings += outcome.crossings;
    effort.most_crossings -= outcome.crossings;
    if (!outcome.arrived) return false;
    if (judge_point(friction, stage, result)) return true;
    centre = point.l;
    const bool leapt = effort.most_missed < unbounded;
    const double missed = missed_by(form_, modes, point);
    const bool leaps =
        leaping && effort.delta == leap_delta && !leapt && missed > hardly_nearer * former;
    if (leaps) {
      leap *= leap_growth;
      go_on(form_, start, leap, most_leap_force * scales_.weight, centre);
    }
    effort.most_missed =
        leaps ? std::max(most_leap_misses * missed, settings_.tolerance) : unbounded;
    former = leapt ? unbounded : missed;
    effort.delta = std::max(near_delta_fall * effort.delta, least_delta);
  }
  return false;
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
