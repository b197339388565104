#include "core/qp/coulomb/coulomb_solver.h"

#include <algorithm>
#include <array>

#include "core/qp/coulomb/contact_memory.h"
#include "core/qp/coulomb/coulomb_stages.h"

namespace wuerfel {
namespace {

constexpr int known_factorisations = 12;   ///< of newton from remembered modes
constexpr int guessed_factorisations = 4;  ///< from none
constexpr double apart_share = 1e-6;       ///< of the largest velocity
constexpr int interior_seeds = 8;
constexpr int crossing_seeds = 3;  ///< that are tried across folds as well
constexpr int unsure_seeds = 4;    ///< where no solution need exist
constexpr int lemke_seeds = 3;
constexpr int most_missed = 5;  ///< programs in a row, after which one interior point is tried
/// How interior points of large programs, whose paths fold in many places at once, start and pass folds. The first one is nearly
/// always enough.
struct InteriorTry {
  double spread;
  Folds folds;
};
constexpr std::array tries_of_many{InteriorTry{0.0, Folds::cross}, InteriorTry{1.0, Folds::go_back},
                                   InteriorTry{0.5, Folds::cross},
                                   InteriorTry{2.0, Folds::go_back}};
constexpr std::size_t unsure_tries_of_many = 2;
constexpr int most_pivoted = 120;  ///< contacts of programs that are followed with pivoting

bool any_slides(const FrictionProgram& friction) {
  return std::any_of(friction.contacts.begin(), friction.contacts.end(),
                     [](const FrictionContact& c) { return c.slides != 0 && c.mu > 0.0; });
}

bool any_slips(const std::vector<ContactMode>& modes) {
  return std::ranges::any_of(modes, [](ContactMode mode) { return slip_sign(mode) != 0.0; });
}

/// Whether its bodies, if nothing acted between them, would not meet.
bool is_apart(const ContactUnit& unit) {
  return !unit.equality && unit.h.n * unit.per_velocity.n < -apart_share;
}

/// Whether a solution is known to exist. [Anitescu, Potra 1997]
bool may_stand(const FrictionProgram& friction) {
  return friction.program.allows_rest() && !any_slides(friction);
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
  explicit Work(const CoulombSettings& settings) : stages(settings) {}
  bool start(std::span<const std::uint64_t> keys);
  bool find_near(const FrictionProgram& friction, bool known, CoulombResult& result);
  bool find(const FrictionProgram& friction,
            std::span<const std::uint64_t> keys,
            CoulombResult& result);
  bool insist(const FrictionProgram& friction, CoulombResult& result);
  bool try_all(const FrictionProgram& friction, CoulombResult& result);

  CoulombStages stages;
  ContactMemory memory;
  double force_unit = 0.0;  ///< of the program
  int missed = 0;           ///< programs in a row that have a solution, which was not found
};

CoulombSolver::CoulombSolver(const CoulombSettings& settings)
    : work_(std::make_unique<Work>(settings)) {}
CoulombSolver::~CoulombSolver() = default;

void CoulombSolver::forget() {
  work_->memory.forget();
  work_->stages.forget();
  work_->missed = 0;
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
  const bool one_key_each = keys.empty() || keys.size() == friction.contacts.size();
  if (!one_key_each || !defect(friction).empty()) {
    forget();
    return;
  }
  w.stages.prepare(friction);
  w.force_unit = friction.force_unit > 0.0 ? friction.force_unit : w.stages.weight();
  const bool solved = w.find(friction, keys, result);
  if (friction.refines && !solved) {
    result.status = QpStatus::inaccurate;
    return;
  }
  if (!solved) w.stages.take(result.multiplier);
  result.status = solved ? QpStatus::optimal : QpStatus::inaccurate;
  if (any_slides(friction) && (!solved || w.stages.jams(friction, result)))
    result.status = QpStatus::infeasible;
  w.memory.remember(keys, w.force_unit, w.stages.modes, w.stages.forces());
}

/// Modes and forces from memory; false if there are none.
bool CoulombSolver::Work::start(std::span<const std::uint64_t> keys) {
  const ContactForm& form = stages.form();
  stages.modes.resize(form.count());
  stages.point.reset(form);
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    stages.modes[i] = is_apart(unit) ? ContactMode::open : CoulombStages::first_mode(unit);
  }
  return memory.recall(form, keys, force_unit, stages.modes, stages.point.l);
}

bool CoulombSolver::Work::find_near(const FrictionProgram& friction,
                                    bool known,
                                    CoulombResult& result) {
  if (known && stages.certificate(friction, result)) return true;
  const int most = known ? known_factorisations : guessed_factorisations;
  return stages.newton(friction, most, result);
}

/// Where slips are known nothing is convex, and the solution nearest to the former modes comes first.
bool CoulombSolver::Work::find(const FrictionProgram& friction,
                               std::span<const std::uint64_t> keys,
                               CoulombResult& result) {
  const bool known = start(keys);
  if (find_near(friction, known, result)) return true;
  if (friction.refines) return false;
  if (any_slides(friction)) {
    start(keys);
    const auto seed = static_cast<std::uint64_t>(friction.contacts.size());
    if (stages.follow(friction, PathStart::here, seed, Pivoting::none, result)) return true;
  } else {
    // What slides is lifted by the convex relaxation: there is no use in asking it again.
    const bool slides = known && any_slips(stages.modes);
    if (known) {
      start(keys);
      if (stages.harden(friction, soft_delta, CoulombStage::newton, result)) return true;
      start(keys);
      if (stages.follow_shortly(friction, result)) return true;
    }
    if (!slides && stages.relax(friction, result)) return true;
  }
  return insist(friction, result);
}

/// What is dear, and hardly ever needed beyond the first interior point, which has to do where nothing has helped for some time:
/// of some mass ratios beside large coefficients of friction solutions have no more digits.
bool CoulombSolver::Work::insist(const FrictionProgram& friction, CoulombResult& result) {
  stages.solvable = may_stand(friction);
  const bool solved = missed < most_missed || !stages.solvable
                          ? try_all(friction, result)
                          : stages.interior(friction, 0.0, 0, Folds::go_back, result);
  if (stages.solvable) missed = solved ? 0 : missed + 1;
  return solved;
}

/// Where no solution need exist (restitution, of which less is asked then) what is dearest is left out.
bool CoulombSolver::Work::try_all(const FrictionProgram& friction, CoulombResult& result) {
  const auto seed = static_cast<std::uint64_t>(friction.contacts.size());
  if (friction.contacts.size() > most_from_open) {
    const std::size_t tries = stages.solvable ? tries_of_many.size() : unsure_tries_of_many;
    return std::ranges::any_of(std::span(tries_of_many).first(tries),
                               [&, k = seed](const InteriorTry& t) mutable {
                                 return stages.interior(friction, t.spread, k++, t.folds, result);
                               });
  }
  const int seeds = stages.solvable ? interior_seeds : unsure_seeds;
  for (int k = 0; k < seeds; ++k) {
    const double spread = k == 0 ? 0.0 : 0.5 + 0.5 * k;
    if (stages.interior(friction, spread, seed + k, Folds::go_back, result)) return true;
    if (k < crossing_seeds && stages.interior(friction, spread, seed + k, Folds::cross, result))
      return true;
  }
  stages.take(result.multiplier);
  if (stages.follow(friction, PathStart::here, seed, Pivoting::none, result)) return true;
  if (stages.follow(friction, PathStart::open, seed, Pivoting::none, result)) return true;
  if (!stages.solvable) return false;
  for (int k = 1; k <= lemke_seeds && friction.contacts.size() <= most_pivoted; ++k) {
    if (stages.follow(friction, PathStart::open, seed + 7919U * k, Pivoting::full, result))
      return true;
  }
  return false;
}

}  // namespace wuerfel
