/// Primal-dual interior point method with Mehrotra's predictor and corrector [Mehrotra 1992] and a
/// proximal term on the multipliers [Pougkakiotis, Gondzio 2021].
///
/// With distances p, q >= 0 from the
/// two ends of a row's range,
///
///     G y - p + q = h,   p (lambda - force_min) = mu,   q (force_max - lambda) = mu,
///     y = G' lambda,
///
/// where an infinite end has no p or q. Eliminating all but y leaves
///
///     K = I + G' D G,   1/D = p / (lambda - force_min) + q / (force_max - lambda) + delta.
///
/// The delta is proximal (the right-hand side is exact), so that equalities and redundant rows need
/// nothing special.
#pragma once

#include <vector>

#include "core/qp/block/least_distance.h"
#include "core/qp/methods/method_outcome.h"
#include "core/qp/residual_meter.h"

namespace wuerfel {

class InteriorPointMethod {
 public:
  /// Solves to the residual aimed at, or as far as it gets. `warm` starts near the
  /// last solution. `proximal` is delta / |g|^2 of rows with an end: the larger it is the better K
  /// is conditioned, and the slower nearly dependent rows settle. It is raised where K gets too
  /// ill-conditioned.
  MethodOutcome run(LeastDistance& problem,
                    const ResidualScales& scales,
                    const Aim& aim,
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
  struct Iterate {
    std::vector<double> lambda, p, q;
    std::vector<double> rest;  ///< h - G y
    std::vector<double> r;     ///< h - G y + p - q
    std::vector<Quad> y;
  };
  struct Direction {
    std::vector<double> lambda, p, q;
    std::vector<Quad> y;
    std::vector<double> Gy;
  };
  /// An iterate with the smaller of every multiplier and its distance put to zero.
  struct Rounded {
    std::vector<double> lambda;
    std::vector<Quad> unbalance;  ///< G' lambda - y
  };
  /// What the steps so far have shown.
  struct Progress {
    int lost = 0;            ///< steps in a row that gained nothing
    double former_mu = 0.0;  ///< the mean product of the step before
    double affine = 0.0;     ///< what the last affine step would have left of the products
    bool creeping = false;   ///< products hardly fall any more
    bool rounded = false;    ///< K was too ill-conditioned once
  };

  void resize(const LeastDistance& problem);
  void start(const LeastDistance& problem, bool warm);
  void find_rest(const LeastDistance& problem);
  [[nodiscard]] double complementarity(const LeastDistance& problem, double step) const;
  double round_off(const LeastDistance& problem, const ResidualScales& scales);
  bool keeps_gaining(double worst, double centre, MethodOutcome& outcome);
  [[nodiscard]] double choose_proximal(
      const LeastDistance& problem, int step, double mu, double tolerable, double proximal);
  double find_unbalance(const LeastDistance& problem);
  void factorise(LeastDistance& problem, double proximal);
  void find_direction(LeastDistance& problem, double centring, bool corrector);
  [[nodiscard]] double longest_step(const LeastDistance& problem) const;
  void move(double step);

  bool solved_ = false;
  int count_ = 0;  ///< of finite ends
  Iterate at_;
  Direction step_;
  Rounded near_;
  Progress progress_;
  std::vector<Quad> unbalance_;  ///< G' lambda - y of the iterate, rounding only
  std::vector<double> weight_;   ///< D
  std::vector<double> rhs_, pull_;
  std::vector<double> best_;
  std::vector<Quad> best_y_;
};

}  // namespace wuerfel
