/// Primal-dual interior point method with Mehrotra's predictor and corrector and a proximal term on
/// the multipliers.
///
/// S. Mehrotra, On the implementation of a primal-dual interior point method, SIAM J. Optimization
/// 2 (1992); S. Pougkakiotis, J. Gondzio, An interior point-proximal method of multipliers for
/// convex quadratic programming, Comput. Optim. Appl. 78 (2021). With distances p, q >= 0 from the
/// two ends of a row's range,
///
///     G y - p + q = h,   p (lambda - force_min) = mu,   q (force_max - lambda) = mu,   y = G'
///     lambda,
///
/// where an infinite end has no p or q. Eliminating all but y leaves K = I + G' D G, 1/D = p /
/// (lambda - force_min)
/// + q / (force_max - lambda) + delta. The delta is proximal (the right-hand side is exact), so
/// that equalities and redundant rows need nothing special.
#pragma once

#include <vector>

#include "core/qp/least_distance.h"
#include "core/qp/method_outcome.h"
#include "core/qp/optimality_meter.h"

namespace wuerfel {

class InteriorPointMethod {
 public:
  /// Solves to `goal` in the measure of QpResidual, or as far as it gets. `warm` starts near the
  /// last solution. `proximal` is delta / |g|^2 of rows with an end: the larger it is the better K
  /// is conditioned, and the slower nearly dependent rows settle. It is raised where K gets too
  /// ill-conditioned.
  MethodOutcome run(LeastDistance& problem,
                    const ResidualScales& scales,
                    double goal,
                    bool warm,
                    double proximal);
  void forget() { solved_ = false; }
  /// Whether the last solution can start the next one.
  [[nodiscard]] bool can_start_warm(const LeastDistance& problem) const {
    return solved_ && problem.same_rows();
  }

  [[nodiscard]] const std::vector<Quad>& y() const { return best_y_; }
  [[nodiscard]] const std::vector<double>& multiplier() const { return best_; }

 private:
  void keep_best(double worst, MethodOutcome& outcome);
  void resize(const LeastDistance& problem);
  void start(const LeastDistance& problem, bool warm);
  void find_rest(const LeastDistance& problem);
  [[nodiscard]] double complementarity(const LeastDistance& problem) const;
  [[nodiscard]] double affine_complementarity(const LeastDistance& problem, double step) const;
  [[nodiscard]] double largest_force(const ResidualScales& scales) const;
  double find_unbalance(const LeastDistance& problem);
  void set_weights(const LeastDistance& problem);
  void find_direction(LeastDistance& problem, double centring, bool corrector);
  [[nodiscard]] double longest_step(const LeastDistance& problem) const;
  void move(double step);
  double round_off(const LeastDistance& problem, const ResidualScales& scales);

  bool solved_ = false;
  double proximal_ = 0.0;
  double former_mu_ = 0.0;
  bool creeping_ = false;  ///< products hardly fall any more
  bool rounded_ = false;   ///< K was too ill-conditioned once
  int count_ = 0;          ///< of finite ends
  std::vector<double> lambda_, p_, q_, d_lambda_, d_p_, d_q_, weight_, rhs_, Gd_, best_, scratch_;
  std::vector<double> rest_;                      ///< h - G y
  std::vector<double> r_;                         ///< h - G y + p - q
  std::vector<Quad> y_, d_, unbalance_, best_y_;  ///< unbalance: G' lambda - y, rounding only
};

}  // namespace wuerfel
