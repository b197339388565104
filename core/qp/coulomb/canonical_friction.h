/// The forces to show: of all that Coulomb's law allows at the given motion those of least sum of
/// squares of normal and tangential forces together, the limit of equal, vanishing compliance both
/// ways; and which of them are the only ones possible.
///
///     minimise 1/2 |l|^2   subject to   G' l = s,   l_i in K_i
///
/// where K_i is the cone of friction of a contact that sticks, its edge against the slip of one that
/// slips, and zero of one that opens. (Not the least norm of the multipliers of two rows J_n +- mu
/// J_t, which weighs tangential forces by 1 / mu.) Proximal iteration s_k+1 = s_k + s - G' l, with
/// l = P_K(G z) at the minimum of 1/2 |z|^2 / rho + 1/2 |P_K(G z)|^2 - s_k' z by semismooth Newton
/// steps. [Rockafellar 1976b], as in NewtonMethod.
#pragma once

#include <vector>

#include "core/qp/coulomb/contact_form.h"

namespace wuerfel {

struct CanonicalForces {
  std::vector<double> multiplier;  ///< m
  /// One per contact, then one per row of no contact: no other force is possible there.
  std::vector<bool> unique;
  double misfit = 0.0;  ///< |s - G' l| / |s|; above 1e-8 the given multipliers are returned
};

class CanonicalFriction {
 public:
  /// From a solution (x, multipliers) of residual about 1e-10. Rows count with their own length:
  /// write them with unit normals. `with_unique` false leaves the flags false.
  void find(const FrictionProgram& friction,
            const std::vector<double>& x,
            const std::vector<double>& multiplier,
            bool with_unique,
            CanonicalForces& result);

 private:
  enum class Cone : signed char { nothing, free, half_line, edge, cone };
  enum class Side : signed char { out, in, edge_forward, edge_back };
  void classify(const FrictionProgram& friction, const std::vector<double>& x);
  /// The projection of v onto the unit's cone, and on which face it falls.
  [[nodiscard]] Side project(int i, Pair& v) const;
  [[nodiscard]] ContactForm::Weight face_weight(int i, Side side) const;
  /// The forces nearest to `wish` with G' l = s; their misfit.
  double nearest(const std::vector<Pair>& wish);
  bool minimise(const std::vector<Pair>& wish);
  void find_direction();
  [[nodiscard]] double root_of_slope(const std::vector<Pair>& wish);
  void move(double step);
  double slope(const std::vector<Pair>& wish, double step);
  bool find_sides(const std::vector<Pair>& wish);
  void mark_moved(const std::vector<Pair>& canonical,
                  double least,
                  std::vector<bool>& unique) const;
  void mark_unique(CanonicalForces& result, const std::vector<Pair>& canonical);

  ContactForm form_;
  QuadraticProgram program_;
  std::vector<Cone> cone_;
  std::vector<double> slip_;  ///< sign of u_t of units that slip
  std::vector<Side> side_;
  std::vector<ContactForm::Weight> weight_;
  std::vector<Pair> Gz_, Gd_, l_;
  std::vector<Quad> s_, shift_, z_, d_, balance_;
  double rho_ = 0.0;
};

}  // namespace wuerfel
