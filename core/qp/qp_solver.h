/// The solver slot: one `solve` for every quadratic program of the house.
#pragma once

#include <memory>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "core/qp/quadratic_program.h"

namespace wuerfel {

enum class QpStatus {
  optimal,      ///< residual within tolerance
  inaccurate,   ///< a usable point whose residual misses the tolerance; never to be used silently
  infeasible,   ///< no x satisfies the restrictions
  invalid,      ///< the program itself is malformed (NaN, mass <= 0, wrong sizes)
  unavailable,  ///< the solver could not be loaded; QpSolver::trouble() says why
};
std::string_view to_string(QpStatus status);

/// A program that no solver has answered, because it is malformed or the solver is missing. The text
/// is QpSolver::trouble().
class SolverError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Optimality residual of a point, found by an independent function. All four are relative: forces
/// to the largest force at hand (a multiplier times its row, or a weight M f), accelerations to the
/// largest at hand (f, or b over its row). Complementarity is a smaller-of, not a product: a
/// product of 1e-10 still allows accelerations wrong by 1e-5 g.
struct QpResidual {
  double stationarity = 0.0;     ///< |M (x - f) - J' lambda|
  double primal = 0.0;           ///< violation of J x = b and J x >= b
  double dual = 0.0;             ///< violation of force_min <= lambda <= force_max
  double complementarity = 0.0;  ///< max_i min(lambda_i - force_min_i, slack_i), and likewise above
  [[nodiscard]] double worst() const;
};

struct [[nodiscard]] QpResult {
  QpStatus status = QpStatus::invalid;
  std::vector<double> x;           ///< n
  std::vector<double> multiplier;  ///< m
  QpResidual residual;
  int iterations = 0;
};

/// Independent of every solver. `x` of size n, `multiplier` of size m; infinite where one of them
/// is not a number.
QpResidual optimality_residual(const QuadraticProgram& program,
                               const std::vector<double>& x,
                               const std::vector<double>& multiplier);

/// Whether all values are numbers.
bool all_finite(const std::vector<double>& values);

/// The first thing wrong with the program, or an empty text.
std::string_view defect(const QuadraticProgram& program);

class QpSolver {
 public:
  virtual ~QpSolver() = default;
  /// Solves into `result`, whose vectors are reused. A malformed program gives a status, never an
  /// exception.
  virtual void solve(const QuadraticProgram& program, QpResult& result) = 0;
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// Why the last answer was `invalid` or `unavailable`, for people; empty otherwise.
  [[nodiscard]] virtual std::string_view trouble() const { return {}; }
  /// Forgets what was remembered of earlier programs (warm start, symbolic work).
  virtual void forget() {}
};

enum class QpMethod {
  automatic,  ///< newton, and interior_point where that does not finish; remembers which of them
              ///< did
  newton,     ///< proximal augmented Lagrangian; ends at the multipliers of least norm; best for
              ///< stacks and small programs
  interior_point,  ///< regularised Mehrotra method; never much slower, best for big or jammed piles
  ipopt,           ///< the independent referee: milliseconds even for one cube, driven to rounding
};
std::string_view to_string(QpMethod method);

struct QpSettings {
  /// On QpResidual::worst(); smaller is slower and ends at rounding, about 1e-13.
  double tolerance = 1e-10;
  /// Of automatic: bodies that are light beside others are to be as exact as their own forces.
  bool by_block = false;
  /// Above this tolerance an answer within it is not improved, and newton, whose answers are exact or
  /// none, is not tried.
  [[nodiscard]] bool wants_exact() const { return tolerance <= 1e-9; }
};

std::unique_ptr<QpSolver> make_qp_solver(QpMethod method, const QpSettings& settings = {});

}  // namespace wuerfel
