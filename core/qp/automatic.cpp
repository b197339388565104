#include "core/qp/automatic.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

constexpr int small_problem = 300;   ///< blocks up to which newton is cheap
constexpr int large_problem = 1500;  ///< blocks from which it is not tried again
/// Part of the rows that the first step may contradict the guess on.
constexpr double most_wrong_guesses = 0.2;
constexpr double most_wrong_guesses_of_large = 0.02;
constexpr int most_guessing_factorisations = 12;  ///< beyond small problems, without known sides
constexpr int most_guessing_factorisations_of_large = 8;
constexpr int retry_newton_after = 32;

/// What a guess of the loaded rows must reach to be taken, up to how many blocks one is worth its
/// linear algebra, and the longest pause, in solves, after guesses that failed.
constexpr double guess_tolerance = 1e-11;
constexpr int most_guessed_blocks = 64;
constexpr std::size_t few_loaded_rows = 32;  ///< for which it is worth it in larger programs, too
constexpr int longest_pause = 64;

/// Up to so many rows whatever is not exact is finished off: it costs next to nothing.
constexpr int small_program = 24;
constexpr double finished_share = 0.1;  ///< of the residual before
constexpr int most_refined_rows = 400;

/// Bodies that are left at rest: whoever looks takes these for exact zeros.
bool is_zero(const std::vector<double>& x, const QuadraticProgram& program) {
  constexpr double nothing = 5e-11;  // of the largest target
  double target = 0.0;
  for (const double f : program.target)
    target = std::max(target, std::abs(f));
  return std::ranges::all_of(x, [&](double v) { return std::abs(v) <= nothing * target; });
}

}  // namespace

AutomaticSolver::AutomaticSolver(const QpSettings& settings, const BlockKernels& kernels)
    : methods_(settings, kernels) {}

void AutomaticSolver::forget() {
  methods_.forget();
  newton_ = {};
  guesses_ = {};
}

void AutomaticSolver::solve(const QuadraticProgram& program, QpResult& result) {
  if (!guess(program, result)) {
    if (methods_.begin(program, result)) {
      search(program, result);
      methods_.end(result);
    } else if (result.status == QpStatus::invalid) {
      forget();
      return;
    }
    improve(program, result);
  }
  remember_loads(program, result);
}

void AutomaticSolver::search(const QuadraticProgram& program, QpResult& result) {
  if (newton_is_due()) {
    newton_.since = 0;
    // A stalled answer may pass, but nearly degenerate programs turn it into a much larger error of
    // x.
    newton_.knows_sides = methods_.run_newton(program, newton_effort(), result)
                          && result.residual.worst() <= methods_.goal();
    newton_.won = newton_.knows_sides || result.status == QpStatus::infeasible;
    if (newton_.won) return;
  }
  methods_.run_interior_point(program, result);
  methods_.remember_interior_point();
  newton_.knows_sides = true;
}

/// After newton itself, or when its turn comes again: at once after the first answer of the other
/// method, later now and then.
bool AutomaticSolver::newton_is_due() {
  if (!methods_.settings().wants_exact()) return false;
  ++newton_.since;
  if (newton_.won) return true;
  if (!newton_.tried) {
    newton_.tried = true;
    return true;
  }
  if (methods_.blocks() > large_problem) return false;
  if (newton_.knows_sides && !newton_.tried_known_sides) {
    newton_.tried_known_sides = true;
    return true;
  }
  return newton_.since >= retry_newton_after;
}

NewtonEffort AutomaticSolver::newton_effort() const {
  NewtonEffort effort;
  if (newton_.knows_sides || methods_.blocks() <= small_problem) return effort;
  const bool large = methods_.blocks() > large_problem;
  effort.most_changes = large ? most_wrong_guesses_of_large : most_wrong_guesses;
  effort.most_factorisations =
      large ? most_guessing_factorisations_of_large : most_guessing_factorisations;
  return effort;
}

bool AutomaticSolver::guess(const QuadraticProgram& program, QpResult& result) {
  if (program.row_name.empty() || guesses_.loaded.empty()) return false;
  if (program.blocks() > most_guessed_blocks && guesses_.loaded.size() > few_loaded_rows)
    return false;
  const int pause = std::min((1 << std::min(guesses_.failed, 16)) - 1, longest_pause);
  if (guesses_.since++ < pause) return false;
  guesses_.since = 0;
  mark_loaded(program);
  const bool right = active_set_.solve(program, guess_tolerance, tight_, result);
  guesses_.failed = right ? 0 : guesses_.failed + 1;
  return right;
}

/// Where a method stops short of its goal it has nearly always found out which rows carry force; with
/// them as equalities the rest is one linear system.
void AutomaticSolver::improve(const QuadraticProgram& program, QpResult& result) {
  if (program.row_name.empty()) return;
  const double reached = result.residual.worst();
  if (result.status == QpStatus::inaccurate) {
    finish_off(program, methods_.settings().tolerance, result);
  } else if (result.status == QpStatus::optimal && reached > exact_residual
             && program.rows() <= small_program) {
    finish_off(program, finished_share * reached, result);
  }
  if (!methods_.settings().by_block || result.status != QpStatus::optimal
      || program.rows() > most_refined_rows || is_zero(result.x, program))
    return;
  active_set_.refine(program, result);
}

void AutomaticSolver::finish_off(const QuadraticProgram& program,
                                 double tolerance,
                                 QpResult& result) {
  remember_loads(program, result);
  mark_loaded(program);
  QpResult finished;
  if (active_set_.solve(program, tolerance, tight_, finished)) result = std::move(finished);
}

void AutomaticSolver::remember_loads(const QuadraticProgram& program, const QpResult& result) {
  guesses_.loaded.clear();
  if (program.row_name.empty() || result.multiplier.size() != program.row_name.size()) return;
  double largest = 0.0;
  for (const double force : result.multiplier)
    largest = std::max(largest, force);
  for (std::size_t row = 0; row < program.row_name.size(); ++row) {
    if (result.multiplier[row] > loaded_share * largest)
      guesses_.loaded.push_back(program.row_name[row]);
  }
  std::ranges::sort(guesses_.loaded);
}

/// `tight_` becomes the rows that were loaded when last remembered.
void AutomaticSolver::mark_loaded(const QuadraticProgram& program) {
  tight_.clear();
  for (const std::int64_t name : program.row_name)
    tight_.push_back(std::ranges::binary_search(guesses_.loaded, name) ? 1 : 0);
}

}  // namespace wuerfel
