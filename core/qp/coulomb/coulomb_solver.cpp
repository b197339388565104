#include "core/qp/coulomb/coulomb_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/qp/coulomb/cone_interior_point.h"
#include "core/qp/coulomb/convex_relaxation.h"
#include "core/qp/coulomb/mode_newton.h"
#include "core/qp/coulomb/mode_path.h"

namespace wuerfel {
namespace {

constexpr double usual_delta = 1e-8;
constexpr double pivoted_delta = 1e-11;
constexpr double least_path_delta = 1e-12;
constexpr double path_delta = 1e-6;  ///< of paths: K keeps its digits without pivoting
constexpr double convex_tolerance = 1e-12;
constexpr int lemke_seeds = 3;
constexpr int most_pivoted = 300;  ///< contacts of programs that are followed with pivoting
constexpr int interior_seeds = 8;
constexpr int crossings_per_contact = 12;
constexpr int most_proximal_steps = 8;
constexpr double jamming_force = 1e6;  ///< in weights

bool any_slides(const FrictionProgram& friction) {
  return std::any_of(friction.contacts.begin(), friction.contacts.end(),
                     [](const FrictionContact& c) { return c.slides != 0 && c.mu > 0.0; });
}

/// Whether x = 0 satisfies all rows, so that a solution exists. [Anitescu, Potra 1997]
bool may_stand(const FrictionProgram& friction) {
  const QuadraticProgram& p = friction.program;
  std::vector<char> tangential(p.bound.size(), 0);
  for (const FrictionContact& c : friction.contacts)
    if (c.tangent >= 0) tangential[c.tangent] = 1;
  for (int row = 0; row < p.rows(); ++row) {
    const bool exactly = tangential[row] != 0 || p.is_equality(row);
    if (exactly ? p.bound[row] != 0.0 : p.bound[row] > 0.0) return false;
  }
  return !any_slides(friction);
}

}  // namespace

std::string_view to_string(CoulombStage stage) {
  switch (stage) {
    case CoulombStage::none:
      return "none";
    case CoulombStage::certificate:
      return "certificate";
    case CoulombStage::newton:
      return "newton";
    case CoulombStage::convex:
      return "convex";
    case CoulombStage::interior:
      return "interior";
    case CoulombStage::path:
      return "path";
    case CoulombStage::lemke:
      return "lemke";
  }
  return "none";
}

struct CoulombSolver::Work {
  explicit Work(const CoulombSettings& asked) : settings(asked), convex(convex_tolerance) {}

  bool find(const FrictionProgram& friction,
            std::span<const std::uint64_t> keys,
            CoulombResult& result);
  [[nodiscard]] bool jams(const FrictionProgram& friction, const CoulombResult& result) const;
  bool certificate(const FrictionProgram& friction, CoulombResult& result);
  [[nodiscard]] bool rows_hold() const;
  void recall(std::span<const std::uint64_t> keys);
  void remember(std::span<const std::uint64_t> keys);
  bool newton(const FrictionProgram& friction, CoulombResult& result);
  bool relax(const FrictionProgram& friction, CoulombResult& result);
  bool interior(const FrictionProgram& friction,
                double spread,
                std::uint64_t seed,
                CoulombResult& result);
  bool follow(const FrictionProgram& friction,
              bool from_open,
              std::uint64_t seed,
              double delta,
              CoulombResult& result);
  bool settle(const FrictionProgram& friction,
              CoulombStage stage,
              double delta,
              CoulombResult& result);
  bool accept(const FrictionProgram& friction, CoulombStage stage, CoulombResult& result);
  bool judge_point(const FrictionProgram& friction, CoulombStage stage, CoulombResult& result);
  void take(const std::vector<double>& multiplier_given);
  void find_modes();
  [[nodiscard]] ContactMode first_mode(const ContactUnit& unit) const;

  CoulombSettings settings;
  CoulombJudge judge;
  CoulombScales judge_scales;
  ContactForm form;
  ConvexRelaxation convex;
  ModeNewton mode_newton;
  ConeInteriorPoint cone_interior;
  ModePath mode_path;
  std::vector<ContactMode> modes;
  ContactPoint point;
  std::vector<Pair> cone;
  std::vector<double> x, multiplier;
  struct Memory {
    std::vector<std::uint64_t> keys;
    std::vector<ContactMode> modes;
    std::vector<Pair> l;
    int rows = 0;
  } memory;
  bool recalled = false;
  bool ended_on_ray = false;           ///< the last path
  Pivoting pivoting = Pivoting::none;  ///< of paths
};

CoulombSolver::CoulombSolver(const CoulombSettings& settings)
    : work_(std::make_unique<Work>(settings)) {}
CoulombSolver::~CoulombSolver() = default;

void CoulombSolver::forget() {
  work_->memory = {};
  work_->convex.forget();
  work_->form.forget();
}

void CoulombSolver::solve(const FrictionProgram& friction,
                          CoulombResult& result,
                          std::span<const std::uint64_t> keys) {
  Work& w = *work_;
  result.status = QpStatus::invalid;
  result.stage = CoulombStage::none;
  result.factorisations = result.crossings = 0;
  result.residual = {.stationarity = unbounded};
  result.x.clear();
  if (!defect(friction).empty()) {
    forget();
    return;
  }
  w.judge_scales = w.judge.measure_scales(friction.program);
  w.form.prepare(friction, w.judge_scales);
  w.recall(keys);
  const bool solved = w.find(friction, keys, result);
  result.status = solved ? QpStatus::optimal : QpStatus::inaccurate;
  if (any_slides(friction) && (!solved || w.jams(friction, result)))
    result.status = QpStatus::infeasible;
  w.remember(keys);
}

/// The stages one after the other. Where slips are known nothing is convex, and the solution nearest
/// to the former modes comes first.
bool CoulombSolver::Work::find(const FrictionProgram& friction,
                               std::span<const std::uint64_t> keys,
                               CoulombResult& result) {
  const auto seed = static_cast<std::uint64_t>(friction.contacts.size());
  pivoting = Pivoting::none;
  if (certificate(friction, result) || newton(friction, result)) return true;
  if (any_slides(friction)) {
    recall(keys);
    if (follow(friction, false, seed, path_delta, result)) return true;
  } else if (relax(friction, result)) {
    return true;
  }
  if (interior(friction, 0.0, seed, result)) return true;
  for (int k = 1; k < interior_seeds; ++k)
    if (interior(friction, 0.5 + 0.5 * k, seed + k, result)) return true;
  if (follow(friction, false, seed, path_delta, result)) return true;
  if (follow(friction, true, seed, path_delta, result)) return true;
  if (ended_on_ray && !may_stand(friction)) return false;
  pivoting = Pivoting::full;
  for (int k = 1; k <= lemke_seeds && form.count() <= most_pivoted; ++k)
    if (follow(friction, true, seed + 7919U * k, usual_delta, result)) return true;
  return false;
}

/// Forces beyond everything: the effective inverse mass of what slips has all but vanished.
bool CoulombSolver::Work::jams(const FrictionProgram& friction, const CoulombResult& result) const {
  const auto beyond = [&](const FrictionContact& c) {
    const double force = result.multiplier[c.normal] * judge_scales.row_norm[c.normal];
    return force > jamming_force * judge_scales.weight;
  };
  return std::any_of(friction.contacts.begin(), friction.contacts.end(), beyond);
}

ContactMode CoulombSolver::Work::first_mode(const ContactUnit& unit) const {
  if (unit.tangent < 0) return ContactMode::closed;
  return unit.slides != 0 ? slip_mode(unit.slides) : ContactMode::stick;
}

/// Modes and forces of the contacts that are still there; others stick.
void CoulombSolver::Work::recall(std::span<const std::uint64_t> keys) {
  recalled =
      !memory.modes.empty()
      && (keys.empty() ? memory.keys.empty() && memory.rows == form.count() : !memory.keys.empty());
  modes.resize(form.count());
  point.reset(form);
  for (int i = 0; i < form.count(); ++i)
    modes[i] = first_mode(form.units()[i]);
  if (!recalled) return;
  for (int i = 0; i < form.count(); ++i) {
    int from = i;
    if (!keys.empty()) {
      if (i >= static_cast<int>(keys.size())) break;
      const auto found = std::lower_bound(memory.keys.begin(), memory.keys.end(), keys[i]);
      if (found == memory.keys.end() || *found != keys[i]) continue;
      from = static_cast<int>(found - memory.keys.begin());
    }
    const ContactUnit& unit = form.units()[i];
    const ContactMode mode = memory.modes[from];
    if (mode != ContactMode::open && unit.slides == 0
        && (unit.tangent >= 0) != (mode != ContactMode::closed))
      continue;
    if (unit.equality) continue;
    if (mode != ContactMode::open && unit.slides != 0) continue;
    modes[i] = mode;
    point.l[i] = memory.l[from];
  }
}

void CoulombSolver::Work::remember(std::span<const std::uint64_t> keys) {
  memory.rows = form.count();
  memory.keys.assign(keys.begin(), keys.end());
  memory.modes = modes;
  memory.l = cone;
  if (keys.empty()) return;
  std::vector<int> order(keys.size());
  for (int i = 0; i < static_cast<int>(order.size()); ++i)
    order[i] = i;
  std::sort(order.begin(), order.end(), [&](int a, int b) { return keys[a] < keys[b]; });
  for (std::size_t k = 0; k < order.size(); ++k) {
    memory.keys[k] = keys[order[k]];
    memory.modes[k] = modes[order[k]];
    memory.l[k] = cone[order[k]];
  }
}

/// A quick look before the judge's: whether rows in force are where they should be.
bool CoulombSolver::Work::rows_hold() const {
  for (int i = 0; i < form.count(); ++i) {
    const double missed = std::abs(point.rest[i].n) * form.units()[i].per_velocity.n;
    if (modes[i] != ContactMode::open && missed > settings.tolerance) return false;
  }
  return true;
}

bool CoulombSolver::Work::certificate(const FrictionProgram& friction, CoulombResult& result) {
  if (!recalled) return false;
  point.recompute(form);
  const bool passed = rows_hold() && judge_point(friction, CoulombStage::certificate, result);
  if (!passed) point.reset(form);
  return passed;
}

bool CoulombSolver::Work::newton(const FrictionProgram& friction, CoulombResult& result) {
  const ModeNewtonOutcome outcome = mode_newton.run(
      form, modes, point, {.delta = usual_delta, .most_factorisations = recalled ? 8 : 4});
  result.factorisations += outcome.factorisations;
  return outcome.settled && judge_point(friction, CoulombStage::newton, result);
}

void CoulombSolver::Work::take(const std::vector<double>& multiplier_given) {
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    point.l[i] = {multiplier_given[unit.normal],
                  unit.tangent >= 0 ? multiplier_given[unit.tangent] : 0.0};
    clamp_to_cone(unit, point.l[i]);
  }
  point.recompute(form);
  find_modes();
}

/// The modes that the forces of the point show.
void CoulombSolver::Work::find_modes() {
  double force = 0.0;
  for (int i = 0; i < form.count(); ++i)
    force = std::max(force, point.l[i].n * form.units()[i].norm.n);
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
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

bool CoulombSolver::Work::relax(const FrictionProgram& friction, CoulombResult& result) {
  const QpStatus status = convex.solve(friction);
  result.factorisations += convex.iterations();
  if (status != QpStatus::optimal && status != QpStatus::inaccurate) return false;
  take(convex.multiplier());
  form.read(point.l, multiplier);
  cone = point.l;
  x = convex.x();
  if (accept(friction, CoulombStage::convex, result)) return true;
  const std::vector<ContactMode> kept_modes = modes;
  const ContactPoint kept_point = point;
  const ModeNewtonOutcome outcome =
      mode_newton.run(form, modes, point, {.delta = usual_delta, .most_factorisations = 5});
  result.factorisations += outcome.factorisations;
  if (outcome.settled && judge_point(friction, CoulombStage::convex, result)) return true;
  modes = kept_modes;
  point = kept_point;
  return false;
}

bool CoulombSolver::Work::interior(const FrictionProgram& friction,
                                   double spread,
                                   std::uint64_t seed,
                                   CoulombResult& result) {
  const ConeInteriorOutcome outcome =
      cone_interior.run(form, judge_scales.weight, {.spread = spread, .seed = seed}, point);
  result.factorisations += outcome.factorisations;
  find_modes();
  if (judge_point(friction, CoulombStage::interior, result)) return true;
  return outcome.worst < 1e-4 && settle(friction, CoulombStage::interior, usual_delta, result);
}

bool CoulombSolver::Work::follow(const FrictionProgram& friction,
                                 bool from_open,
                                 std::uint64_t seed,
                                 double delta,
                                 CoulombResult& result) {
  const CoulombStage stage = from_open ? CoulombStage::lemke : CoulombStage::path;
  ModePathEffort effort{.delta = delta,
                        .pivoting = pivoting,
                        .most_crossings = 100 + crossings_per_contact * form.count()};
  std::vector<Pair> centre(point.l.size(), Pair{});
  for (int k = 0; k < most_proximal_steps; ++k) {
    const ModePathOutcome outcome =
        from_open && k == 0 ? mode_path.run_from_open(form, modes, point, centre, seed, effort)
                            : mode_path.run(form, modes, point, centre, seed + k, effort);
    effort.delta = std::max(0.01 * effort.delta, least_path_delta);
    result.crossings += outcome.crossings;
    ended_on_ray = outcome.ray;
    if (!outcome.arrived) return false;
    if (judge_point(friction, stage, result)) return true;
    if (settle(friction, stage, usual_delta, result)) return true;
    centre = point.l;
  }
  return false;
}

/// Takes the compliance away, modes as they are or nearly.
bool CoulombSolver::Work::settle(const FrictionProgram& friction,
                                 CoulombStage stage,
                                 double delta,
                                 CoulombResult& result) {
  const std::vector<ContactMode> kept_modes = modes;
  const ContactPoint kept_point = point;
  for (const Pivoting how : {Pivoting::none, Pivoting::full}) {
    const double compliance = how == Pivoting::none ? delta : pivoted_delta;
    const ModeNewtonOutcome outcome = mode_newton.run(
        form, modes, point, {.delta = compliance, .pivoting = how, .most_factorisations = 4});
    result.factorisations += outcome.factorisations;
    if (judge_point(friction, stage, result)) return true;
    modes = kept_modes;
    point = kept_point;
  }
  return false;
}

bool CoulombSolver::Work::judge_point(const FrictionProgram& friction,
                                      CoulombStage stage,
                                      CoulombResult& result) {
  cone = point.l;
  for (int i = 0; i < form.count(); ++i)
    clamp_to_cone(form.units()[i], cone[i]);
  form.read(friction.program, point.y, x);
  form.read(cone, multiplier);
  return accept(friction, stage, result);
}

/// Keeps x and multiplier if they are better than the result; true if they are good enough.
bool CoulombSolver::Work::accept(const FrictionProgram& friction,
                                 CoulombStage stage,
                                 CoulombResult& result) {
  const CoulombResidual residual = judge.measure(friction, x, multiplier);
  if (residual.worst() < result.residual.worst() || result.x.empty()) {
    result.residual = residual;
    result.x = x;
    result.multiplier = multiplier;
    result.stage = stage;
  }
  return residual.worst() <= settings.tolerance;
}

}  // namespace wuerfel
