/// The linear piece of Coulomb's law on which every contact is open, sticks or slips one way.
///
///     open    l = 0
///     closed  u_n = 0                       (a row without friction)
///     stick   u_n = 0,  u_t = 0
///     slip    u_n = 0,  l_t = -s mu l_n     s the sign of u_t
///
/// Rows in force have a compliance d = delta |g|^2 against a centre of forces c, u + d (l - c) = 0.
/// Then K = I + G' C G, C the inverse of the compliances, is the only matrix, whatever rows are
/// redundant; moving the centre to the solution and solving again takes the compliance away
/// (proximal point).
#pragma once

#include <vector>

#include "core/qp/coulomb/contact_form.h"
#include "core/qp/coulomb/pivoted_modes.h"
#include "core/qp/coulomb/rank_one_terms.h"

namespace wuerfel {

enum class ContactMode : signed char { open, closed, stick, slip_forward, slip_back };

/// The sign of u_t of a contact that slips, 0 of others.
inline double slip_sign(ContactMode mode) {
  if (mode == ContactMode::slip_forward) return 1.0;
  return mode == ContactMode::slip_back ? -1.0 : 0.0;
}
inline ContactMode slip_mode(double sign) {
  return sign > 0.0 ? ContactMode::slip_forward : ContactMode::slip_back;
}

/// Forces, what they make of the point, and what the rows miss.
struct ContactPoint {
  std::vector<Quad> y;
  std::vector<Pair> l;
  std::vector<Pair> rest;  ///< h - G y, kept by differences
  void reset(const ContactForm& form);
  /// y = G' l, anew.
  void recompute(const ContactForm& form);
  void move(double length, const ContactStep& step);
};

/// The largest of these forces, normal or tangential.
double largest_force(const ContactForm& form, const std::vector<Pair>& l);
/// The largest normal one; 0 where none presses.
double largest_normal_force(const ContactForm& form, const std::vector<Pair>& l);
/// What rows in force miss, relative to the largest velocity.
double missed_by(const ContactForm& form,
                 const std::vector<ContactMode>& modes,
                 const ContactPoint& point);

/// The first contact to change its mode on a way.
struct Crossing {
  double step = unbounded;
  int unit = -1;
  ContactMode to = ContactMode::open;
  /// A unit that comes into another mode where `value`, which grows at `rate`, comes to zero.
  void meet(double value, double rate, int other, ContactMode mode);
  /// A unit in force whose forces, which grow at the rate `dl`, come to the edge of their cone.
  void meet_cone(
      const ContactUnit& contact, ContactMode mode, const Pair& l, const Pair& dl, int other);
};

enum class Pivoting { none, full };

/// Shares of dy to which G' dl - dy is refined: of steps that are final, and of those whose next one takes up the rest.
inline constexpr double fine_balance = 1e-11;
inline constexpr double rough_balance = 1e-4;

class ModeSystem {
 public:
  /// K of these modes; false where it is singular.
  bool factorise(ContactForm& form,
                 const std::vector<ContactMode>& modes,
                 double delta,
                 Pivoting pivoting);
  /// Takes over the new mode of one unit: by a term of rank one, or as `factorise` does where that is cheaper.
  bool change(ContactForm& form, const std::vector<ContactMode>& modes, int unit);
  /// Whether `change` has left the factors as they were.
  [[nodiscard]] bool updated() const { return !terms_.empty(); }
  /// Solves  g dy + d dl = r  for the rows in force and  dy - G' dl = u,  refined. `r` of rows not
  /// in force is not looked at.
  void solve(const ContactForm& form,
             const std::vector<Pair>& r,
             const std::vector<Quad>& u,
             double balance = fine_balance);
  /// Solves it for the same `r` and `u` as the last time, after `updated` by the mode of a unit.
  void solve_again(const ContactForm& form,
                   const std::vector<Pair>& r,
                   const std::vector<Quad>& u,
                   int unit,
                   double balance = fine_balance);
  void move(double length, ContactPoint& point) const { point.move(length, step_); }
  [[nodiscard]] const std::vector<Pair>& dl() const { return step_.dl; }
  [[nodiscard]] const std::vector<Pair>& Gdy() const { return step_.Gdy; }

 private:
  [[nodiscard]] ContactForm::Weight weight_of(const ContactUnit& unit, ContactMode mode) const;
  void refine(const ContactForm& form,
              const std::vector<Pair>& r,
              const std::vector<Quad>& u,
              double balance);

  PivotedModes pivoted_;
  Pivoting pivoting_ = Pivoting::none;
  double delta_ = 0.0;
  RankOneTerms terms_;  ///< of units that have changed since
  std::vector<ContactForm::Weight> weight_;
  ContactStep step_;
  std::vector<Quad> u_;  ///< G' dl - dy
};

/// The forces in their cones and as the mode has them: l_n = 0 where open, l_t = -s mu l_n.
void follow_mode(const ContactUnit& unit, ContactMode mode, Pair& l);
/// The forces in their cones, whatever the mode.
void clamp_to_cone(const ContactUnit& unit, Pair& l);

}  // namespace wuerfel
