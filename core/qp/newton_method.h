/// Proximal augmented Lagrangian with semismooth Newton steps.
///
/// R. T. Rockafellar, Augmented Lagrangians and applications of the proximal point algorithm in
/// convex programming, Math. of Operations Research 1 (1976); D. Sun, K.-C. Toh et al. for its
/// pairing with semismooth Newton. For multipliers lambda the piecewise quadratic
///
///     phi(y) = 1/2 |y|^2 + 1/(2 rho) |clamp(lambda + rho (h - G y))|^2 + (linear beyond the
///     bounds)
///
/// is minimised by Newton steps with K = I + rho G_A' G_A, A the rows whose clamp is inactive, and
/// an exact line search; then lambda := clamp(..), y := G' lambda, and again. While A stays, an
/// outer step is one back-solve, that is, iterative refinement. Starting from lambda = 0 with one
/// rho for all rows gives the multipliers of least sum of squares (the first outer step has them up
/// to O(1/rho), the later ones stay in the range of G_A), whatever was solved before.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/qp/least_distance.h"
#include "core/qp/method_outcome.h"
#include "core/qp/optimality_meter.h"

namespace wuerfel {

/// When to give up.
struct NewtonEffort {
  int most_factorisations = 20;
  int patience = 3;  ///< outer steps in a row that halve nothing
  double most_changes =
      1.0;  ///< part of the rows that the first step may move to another side than guessed
};

class NewtonMethod {
 public:
  /// Solves to `goal` in the measure of QpResidual, or as far as the effort leads.
  MethodOutcome run(LeastDistance& problem,
                    const ResidualScales& scales,
                    double goal,
                    const NewtonEffort& effort);
  void forget() { side_.clear(); }
  /// Makes the next run start from the sides of these multipliers, in the numbering of `problem`.
  void remember(const LeastDistance& problem, const std::vector<double>& multiplier);

  /// The least norm of multipliers, penalised: minimises 1/2 |lambda|^2 over the multipliers with
  /// G' lambda = target, up to 1/rho. Leaves lambda and y = G' lambda. False if
  /// `most_factorisations` were not enough.
  bool least_norm(LeastDistance& problem,
                  const std::vector<Quad>& target,
                  double stiffness,
                  double largest_force,
                  int most_factorisations);

  [[nodiscard]] const std::vector<Quad>& y() const { return y_; }
  [[nodiscard]] const std::vector<double>& multiplier() const { return best_; }

 private:
  void start(const LeastDistance& problem);
  void guess_sides(const LeastDistance& problem);
  void choose_rho(const LeastDistance& problem);
  void first_point(LeastDistance& problem);
  [[nodiscard]] signed char side_of(const LeastDistance& problem,
                                    std::size_t row,
                                    double raw) const;
  bool stay(const LeastDistance& problem);
  bool find_sides(const LeastDistance& problem);
  void update_multipliers(const LeastDistance& problem);
  void find_rest(const LeastDistance& problem);
  bool minimise(LeastDistance& problem, const NewtonEffort& effort);
  std::pair<double, bool> outer_step(const LeastDistance& problem,
                                     const ResidualScales& scales,
                                     double former);
  void stiffen();
  bool prolong(const LeastDistance& problem);
  bool diverges(const LeastDistance& problem);
  bool inner_step(LeastDistance& problem);
  double line_search(const LeastDistance& problem, double slope);
  bool keeps_sides(const LeastDistance& problem) const;

  double rho_ = 0.0;
  double largest_rho_ = 0.0;
  double dead_ =
      0.0;  ///< multipliers this near to a bound are at it, or rows without force and gap chatter
  bool factorised_ = false;
  bool updated_ = false;     ///< the multipliers have just been updated
  bool whole_step_ = false;  ///< the last step went all the way to the Newton point
  int factorisations_ = 0;
  double most_first_changes_ = 0.0;
  bool hopeless_ = false;  ///< too many rows were guessed wrong
  std::vector<signed char>
      side_;  ///< -1 at force_min, +1 at force_max, 0 between: the row is active
  std::vector<signed char> former_side_;
  std::vector<double> lambda_, raw_, Gd_, weight_, force_, best_;
  /// h - G y. Updated by differences between outer steps: rho would blow up the rounding of G y
  /// itself.
  std::vector<double> rest_;
  std::vector<Quad> y_, d_, rhs_;
  std::vector<std::pair<double, int>> breakpoints_;
};

}  // namespace wuerfel
