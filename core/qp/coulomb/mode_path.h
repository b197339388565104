/// The piecewise linear path from a program whose solution is known to the one that is asked.
///
/// The law with compliance (ModeSystem) is F(z) = 0 with F piecewise linear, one piece for each set
/// of modes. From a point with F(z) = r the path F(z) = t r is followed from piece to piece, one
/// contact changing its mode at each crossing, until t = 0; where det K changes its sign t turns
/// back and the path goes on. [Katzenelson 1965] [Eaves 1976] A path that comes back to its first piece is closed and goes
/// nowhere.
///
/// From far away with all contacts open it is Lemke's method on the program of
/// [Anitescu, Potra 1997], and always arrives: a ray of it would have |G'l|^2 + d |l|^2 <= 0.
#pragma once

#include <cstdint>
#include <vector>

#include "core/qp/coulomb/contact_modes.h"

namespace wuerfel {

struct ModePathEffort {
  double delta = 1e-8;
  Pivoting pivoting = Pivoting::none;
  int most_crossings = 1000;
  /// By which the point is moved into its cones, a share of the largest force and of the largest
  /// velocity. What is moved in velocities costs forces of the share over delta.
  double margin = 1e-3;
  double velocity_margin = 1e-3;
  double farthest = unbounded;  ///< t, at which the path is given up
};

struct ModePathOutcome {
  bool arrived = false;  ///< at t = 0
  int crossings = 0;
};

class ModePath {
 public:
  /// From the point given, whose forces are moved a little into their cones. `centre` are the forces
  /// from which compliance counts. Leaves modes and point.
  ModePathOutcome run(ContactForm& form,
                      std::vector<ContactMode>& modes,
                      ContactPoint& point,
                      const std::vector<Pair>& centre,
                      std::uint64_t seed,
                      const ModePathEffort& effort);
  /// From all contacts open, whatever the point was.
  ModePathOutcome run_from_open(ContactForm& form,
                                std::vector<ContactMode>& modes,
                                ContactPoint& point,
                                const std::vector<Pair>& centre,
                                std::uint64_t seed,
                                const ModePathEffort& effort);

 private:
  ModePathOutcome follow(ContactForm& form,
                         std::vector<ContactMode>& modes,
                         ContactPoint& point,
                         const ModePathEffort& effort);
  bool enter(ContactForm& form,
             const std::vector<ContactMode>& modes,
             const ModePathEffort& effort,
             int unit,
             ContactPoint& point);
  [[nodiscard]] Pair slack(const ContactForm& form, const ContactPoint& point, int i) const;
  [[nodiscard]] Pair slack_rate(const ContactForm& form, int i) const;
  void arrive(const ContactForm& form, const std::vector<ContactMode>& modes, ContactPoint& point);
  void correct(const ContactForm& form, const std::vector<ContactMode>& modes, ContactPoint& point);
  void find_tangent(const ContactForm& form, ContactPoint& point);
  [[nodiscard]] double entering_rate(const ContactForm& form,
                                     ContactMode from,
                                     ContactMode to,
                                     int i) const;
  [[nodiscard]] Crossing next_crossing(const ContactForm& form,
                                       const std::vector<ContactMode>& modes,
                                       const ContactPoint& point,
                                       double direction) const;

  ModeSystem system_;
  double delta_ = 0.0;
  double t_ = 0.0;
  std::vector<Pair> r_, centre_, rhs_;
  std::vector<Quad> unbalance_;
};

}  // namespace wuerfel
