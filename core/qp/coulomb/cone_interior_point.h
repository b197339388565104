/// Interior point method on Coulomb's exact law, which is no convex program.
///
/// With alpha, beta >= 0 the parts of the slip, u_t = beta - alpha, the law is three pairs of
/// numbers >= 0 whose products vanish:
///
///     (l_n, u_n),   (mu l_n - l_t, alpha),   (mu l_n + l_t, beta)
///
/// Products are driven to a common (or weighted) tau by Mehrotra's predictor and corrector
/// [Mehrotra 1992]. Eliminating all but y leaves K = I + G' C^-1 G with
///
///     C = [u_n / l_n + d,  0;  mu (B - A),  A + B + d],   A = alpha / (mu l_n - l_t),  B likewise,
///
/// not symmetric; d = delta |g|^2 is proximal (the right-hand side is exact). The central path may
/// fold: there det K changes its sign, and tau has to grow until it changes back. Where many bodies touch it folds in several
/// places at once, and what is held up there does not hold up the others (step_length_of_most).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/qp/coulomb/cone_pairs.h"

namespace wuerfel {

/// What is done where the path folds: tau grows until the path comes back, or steps are damped until they cross over to where it
/// goes on. Going back leads to solutions, but may take for ever where it folds in many places at once; crossing comes near one
/// always, and often stays there.
enum class Folds { go_back, cross };

struct ConeInteriorEffort {
  double goal = 1e-12;  ///< on the smaller of every pair, relative
  double spread = 0.0;  ///< weights of the products are e^(+-spread)
  std::uint64_t seed = 0;
  Folds folds = Folds::go_back;
};

struct ConeInteriorOutcome {
  double worst = unbounded;  ///< of the best point, which is left in `point`
  int factorisations = 0;
};

/// Newton's equations for y.
struct ConeSystem {
  std::vector<ContactForm::Weight> weight;       ///< C^-1
  std::vector<std::array<double, 3>> corrector;  ///< second-order terms of the products
  std::vector<Pair> right;
  std::vector<Quad> missed;  ///< G' (l + dl) - (y + dy)
};

/// Keeps its memory between runs.
class ConeInteriorPoint {
 public:
  /// `weight` is the largest weight of the program, of which forces are shares.
  ConeInteriorOutcome run(ContactForm& form,
                          double weight,
                          const ConeInteriorEffort& effort,
                          ContactPoint& point);

 private:
  ConeIterate at_;
  ConeDirection step_;
  ConeSystem system_;
};

}  // namespace wuerfel
