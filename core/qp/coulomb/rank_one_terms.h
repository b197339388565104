/// K and a few terms of rank one, as contacts ask for that have changed their modes since K was factorised
/// [Sherman, Morrison 1950]:
///
///     K + sum G_i' a_i b_i' G_i,
///
/// G_i the two rows of a unit, a_i and b_i shares of them. A solve costs one with the factors of K and a column for each
/// term. What is lost where terms make it all but singular is for refinement to find.
#pragma once

#include <vector>

#include <Eigen/LU>

#include "core/qp/coulomb/contact_form.h"

namespace wuerfel {

class RankOneTerms {
 public:
  void clear() { terms_.clear(); }
  [[nodiscard]] bool empty() const { return terms_.empty(); }
  /// Adds the term of a unit; false where there are too many of them, or where a number is not finite. `form` keeps the
  /// factors of K until the terms are cleared.
  bool add(const ContactForm& form, int unit, const Pair& a, const Pair& b);
  /// v := (K + terms)^-1 v
  void solve(const ContactForm& form, std::vector<Quad>& v) const;
  /// What solved the system without the last term, of which the right-hand side has a share as well, solves it now:
  /// `missing` is what the rows of its unit lack of that.
  void correct(const ContactForm& form, const Pair& missing, std::vector<Quad>& v) const;

 private:
  struct Term {
    int unit = -1;
    Pair b;
    std::vector<Quad> column;  ///< K^-1 G_i' a
  };
  static double share(const Term& term, const Pair& rows) {
    return term.b.n * rows.n + term.b.t * rows.t;
  }
  void subtract_terms(const ContactForm& form, std::vector<Quad>& v) const;

  std::vector<Term> terms_;
  Eigen::MatrixXd small_;  ///< 1 + b_i' G_i column_k
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

}  // namespace wuerfel
