/// Of all multipliers that balance a force, those of least sum of squares, or nearest to given ones.
///
///     minimise 1/2 |lambda - origin|^2  subject to  G' lambda = target,  force_min <= lambda <= force_max
///
/// is solved by lambda = clamp(origin + G z) for the z that minimises the piecewise quadratic dual
/// sum_i psi_i(<g_i, z>) - <target, z>, psi_i' = clamp: semismooth Newton steps with
/// K = I + rho G_A' G_A, A the rows inside of their ranges, and an exact line search, as
/// [Li, Sun, Toh 2018] for this kind of dual. While A stays a step is one back-solve, that is,
/// iterative refinement. G z is updated by differences: what a body's forces leave of its balance falls
/// to rounding of these forces, however much larger those on other bodies are.
#pragma once

#include <vector>

#include "core/qp/block/least_distance.h"

namespace wuerfel {

struct LeastNormOutcome {
  double misfit = 0.0;  ///< the worst |target - G' lambda| of a block, in parts of its scale
  int factorisations = 0;
};

class LeastNormMethod {
 public:
  /// `target` and `weight` (the least scale of a block; scales grow with the forces of its rows) are
  /// in the numbering of `problem`. `origin` is empty (zeros) or one per row. `inside`: rows that are likely
  /// to be inside of their ranges; empty: all.
  LeastNormOutcome run(LeastDistance& problem,
                       const std::vector<Quad>& target,
                       const std::vector<double>& weight,
                       const std::vector<double>& origin = {},
                       const std::vector<char>& inside = {});

  [[nodiscard]] const std::vector<double>& multiplier() const { return best_; }
  /// Per row: the smaller of the largest forces on its blocks.
  [[nodiscard]] const std::vector<double>& row_scale() const { return row_scale_; }

 private:
  /// A point of the dual: what its multipliers are and leave undone.
  struct Iterate {
    std::vector<double> raw;     ///< origin + G z
    std::vector<double> lambda;  ///< clamp(raw)
    std::vector<Quad> rest;      ///< target - G' lambda
    double misfit = 0.0;
  };
  struct Direction {
    std::vector<Quad> d;     ///< K^-1 rest
    std::vector<double> Gd;  ///< rho G d
  };
  void start(LeastDistance& problem,
             const std::vector<double>& origin,
             const std::vector<char>& inside);
  void find_scales(const LeastDistance& problem, const std::vector<double>& weight);
  void evaluate(const LeastDistance& problem, const std::vector<Quad>& target);
  bool find_active(const LeastDistance& problem);
  void factorise(LeastDistance& problem);
  void find_direction(LeastDistance& problem);
  void move(double length);
  void keep_better(double& best);
  double line_search(const LeastDistance& problem);

  double rho_ = 0.0;
  int factorisations_ = 0;
  Iterate at_;
  Direction step_;
  std::vector<char> active_;
  std::vector<double> active_weight_, scale_, row_scale_, best_;
  std::vector<std::pair<double, int>> breakpoints_;
};

}  // namespace wuerfel
