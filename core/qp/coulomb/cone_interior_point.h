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
/// fold: there det K changes its sign, and tau has to grow until it changes back.
#pragma once

#include <cstdint>
#include <vector>

#include "core/qp/coulomb/contact_modes.h"

namespace wuerfel {

struct ConeInteriorEffort {
  double goal = 1e-12;  ///< on the smaller of every pair, relative
  double delta = 1e-8;
  int most_factorisations = 60;
  double spread = 0.0;  ///< weights of the products are e^(+-spread)
  std::uint64_t seed = 0;
};

struct ConeInteriorOutcome {
  double worst = unbounded;  ///< of the best point, which is left in `point`
  int factorisations = 0;
};

class ConeInteriorPoint {
 public:
  /// `weight` is the largest weight of the program, of which forces are shares.
  ConeInteriorOutcome run(ContactForm& form,
                          double weight,
                          const ConeInteriorEffort& effort,
                          ContactPoint& point);

 private:
  /// The three pairs of a unit: forces, what they are complementary to, targets' weights. Pairs that
  /// a unit does not have stay (1, 0).
  struct Pairs {
    double force[3] = {1.0, 1.0, 1.0};
    double slack[3] = {0.0, 0.0, 0.0};
    double weight[3] = {1.0, 1.0, 1.0};
    double d_force[3] = {0.0, 0.0, 0.0};
    double d_slack[3] = {0.0, 0.0, 0.0};
    double extra[3] = {0.0, 0.0, 0.0};  ///< second-order term of the corrector
    int count = 0;
  };

  /// The partners of a pair as shares of the largest force and velocity.
  struct Product {
    double force = 0.0;
    double slack = 0.0;
  };

  static Product product_of(const ContactUnit& unit, const Pairs& p, int k, double per_force);
  void start(const ContactForm& form, const ConeInteriorEffort& effort);
  [[nodiscard]] double mean_product(double step) const;
  void set_weights(const ContactForm& form, double delta);
  void find_direction(const ContactForm& form, double tau);
  void choose_direction(const ContactForm& form);
  void find_forces(const ContactForm& form);
  [[nodiscard]] double longest_step() const;
  void move(const ContactForm& form, double step);
  [[nodiscard]] double worst_pair(const ContactForm& form, double weight) const;
  void round_off(const ContactForm& form, double weight, ContactPoint& point) const;

  std::vector<Pairs> pairs_;
  std::vector<ContactForm::Weight> weight_;
  ContactPoint at_;
  std::vector<Pair> right_, dl_, Gdy_;
  std::vector<Quad> dy_, u_;
};

}  // namespace wuerfel
