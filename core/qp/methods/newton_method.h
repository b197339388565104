/// Proximal augmented Lagrangian [Rockafellar 1976b] with semismooth Newton steps
/// [Li, Sun, Toh 2018].
///
/// For multipliers lambda the piecewise quadratic
///
///     phi(y) = 1/2 |y|^2 + 1/(2 rho) |clamp(lambda + rho (h - G y))|^2,  linear beyond the bounds,
///
/// is minimised by Newton steps with K = I + rho G_A' G_A, A the rows whose clamp is inactive, and
/// an exact line search; then lambda := clamp(..), y := G' lambda, and again. While A stays, an
/// outer step is one back-solve, that is, iterative refinement. Starting from lambda = 0 with one
/// rho for all rows gives the multipliers of least sum of squares (the first outer step has them up
/// to O(1/rho), the later ones stay in the range of G_A), whatever was solved before.
#pragma once

#include <utility>
#include <vector>

#include "core/qp/block/least_distance.h"
#include "core/qp/methods/method_outcome.h"
#include "core/qp/residual_meter.h"

namespace wuerfel {

/// When to give up.
struct NewtonEffort {
  int most_factorisations = 20;  ///< then another method takes over
  int patience = 3;              ///< outer steps in a row that halve nothing
  /// Part of the rows that the first step may move to another side than guessed.
  double most_changes = 1.0;
};

class NewtonMethod {
 public:
  /// Solves to the residual aimed at, or as far as the effort leads.
  MethodOutcome run(LeastDistance& problem,
                    const ResidualScales& scales,
                    const Aim& aim,
                    const NewtonEffort& effort);
  void forget() { side_.clear(); }
  /// Makes the next run start from the sides of these multipliers, in the numbering of `problem`.
  void remember(const LeastDistance& problem, const std::vector<double>& multiplier);

  [[nodiscard]] const std::vector<Quad>& y() const { return at_.y; }
  [[nodiscard]] const std::vector<double>& multiplier() const { return best_; }

 private:
  /// The stiffness of a run.
  struct Penalty {
    double rho = 0.0;
    double largest_rho = 0.0;
    double dead = 0.0;  ///< half-width of the dead zone, in units of multipliers
  };
  struct Iterate {
    std::vector<Quad> y;
    std::vector<double> lambda;  ///< of the last outer step
    /// h - G y. Updated by differences between outer steps: rho would blow up the rounding of G y
    /// itself.
    std::vector<double> rest;
    std::vector<double> raw;    ///< lambda + rho rest
    std::vector<double> force;  ///< clamp(raw)
  };
  struct Direction {
    std::vector<Quad> rhs;  ///< G' force - y, minus the gradient of phi
    std::vector<Quad> d;    ///< K^-1 rhs
    std::vector<double> Gd;
  };
  /// Where the inner steps are.
  struct Progress {
    int factorisations = 0;
    int steps = 0;  ///< of this minimisation, since the last one
    bool factorised = false;
    bool whole_step = false;  ///< the last step went all the way to the Newton point
    bool updated = false;     ///< the multipliers have just been updated
    bool hopeless = false;    ///< too many rows were guessed wrong
  };

  /// The multiplier of a row that is not active.
  static double bound_of(const LeastDistance& problem, int row, signed char side) {
    return side < 0 ? problem.force_min()[row] : problem.force_max()[row];
  }
  void start(const LeastDistance& problem);
  void guess_sides(const LeastDistance& problem);
  void choose_penalty(const LeastDistance& problem);
  void first_point(LeastDistance& problem);
  void factorise(LeastDistance& problem);
  bool minimise(LeastDistance& problem, const NewtonEffort& effort);
  bool inner_step(LeastDistance& problem, double most_changes);
  [[nodiscard]] signed char side_of(const LeastDistance& problem, int row, double raw) const;
  void stay(const LeastDistance& problem);
  bool find_sides(const LeastDistance& problem, double most_changes);
  [[nodiscard]] bool keeps_sides(const LeastDistance& problem) const;
  double line_search(const LeastDistance& problem);
  std::pair<double, bool> outer_step(const LeastDistance& problem,
                                     const ResidualScales& scales,
                                     double former);
  void update_multipliers(const LeastDistance& problem);
  void stiffen();
  bool prolong(const LeastDistance& problem);
  void find_rest(const LeastDistance& problem);

  /// -1 at force_min, +1 at force_max, 0 between: the row is active.
  std::vector<signed char> side_;
  std::vector<signed char> former_side_;
  Penalty penalty_;
  Progress progress_;
  Iterate at_;
  Direction step_;
  std::vector<double> change_;  ///< of lambda in the last outer step
  std::vector<double> weight_, best_;
  std::vector<std::pair<double, int>> breakpoints_;
};

}  // namespace wuerfel
