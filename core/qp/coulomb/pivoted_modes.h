/// The linear piece of ModeSystem as one matrix of bodies and forces, factorised with pivoting:
///
///     [ 1   -F ] [dy]   [u]
///     [ G    d ] [dl] = [r]
///
/// Slow, and keeps the digits that K = I + F d^-1 G loses where contacts slip. Rows and forces are
/// scaled by their norms.
#pragma once

#include <vector>

#include <Eigen/SparseLU>

#include "core/qp/coulomb/contact_form.h"

namespace wuerfel {

enum class ContactMode : signed char;

class PivotedModes {
 public:
  bool factorise(const ContactForm& form, const std::vector<ContactMode>& modes, double delta);
  /// Leaves dy and dl.
  void solve(const ContactForm& form,
             const std::vector<Pair>& r,
             const std::vector<Quad>& u,
             std::vector<Quad>& dy,
             std::vector<Pair>& dl);

 private:
  using Matrix = Eigen::SparseMatrix<double>;
  /// Where a unit's forces are among the unknowns, -1: not in force; the scales of the unknowns.
  struct Place {
    int n = -1, t = -1;
    double scale_n = 1.0, scale_t = 1.0;
    double slip = 0.0;
  };
  void number(const ContactForm& form, const std::vector<ContactMode>& modes);

  Eigen::SparseLU<Matrix, Eigen::COLAMDOrdering<int>> lu_;
  Matrix matrix_;
  std::vector<Place> place_;
  int size_ = 0;
};

}  // namespace wuerfel
