/// Proximal steps [Rockafellar 1976a], each along a piecewise linear path (ModePath), with as little compliance as its path bears.
///
/// A step moves forces by what rows miss over the compliance, towards the law without compliance. Where little is left to
/// move a small compliance ends sooner; but where contacts snap from one solution to another, which is where rows are missed by
/// little and forces have far to go, only a large one has a path. So compliance shrinks while steps get nearer, and grows where a
/// path leads away; and where steps go the same way one after another the next one takes many of them at once. Thousands of
/// contacts have many places that snap, and each is passed in its own time.
#pragma once

#include <vector>

#include "core/qp/coulomb/mode_path.h"

namespace wuerfel {

struct ProximalPathEffort {
  double delta = 1e-4;            ///< compliance at first
  int most_crossings = 10000;     ///< of all paths, each of which counts as one
  double most_force = unbounded;  ///< by which a step that takes many at once changes forces
};

class ProximalPath {
 public:
  /// Begins at a point, from whose forces compliance counts.
  void begin(const ContactPoint& point, const ProximalPathEffort& effort);
  /// One step; leaves modes and point. False where the effort is spent.
  bool step(ContactForm& form, std::vector<ContactMode>& modes, ContactPoint& point);
  [[nodiscard]] int crossings() const { return crossings_; }  ///< so far

 private:
  [[nodiscard]] bool arrives(ContactForm& form,
                             std::vector<ContactMode>& modes,
                             ContactPoint& point);
  void step_back(const ContactPoint& point);
  void choose_next(const ContactForm& form, double missed, const ContactPoint& point);
  [[nodiscard]] bool goes_on(const std::vector<Pair>& way) const;

  ModePath path_;
  ProximalPathEffort effort_;
  double delta_ = 0.0;
  double times_ = 0.0;         ///< steps that the next one takes at once beside its own
  double former_ = unbounded;  ///< what rows missed after the last step
  std::vector<Pair> centre_;   ///< forces from which compliance counts
  std::vector<Pair> way_;      ///< of the forces in the last step; empty after one that failed
  int paths_ = 0, lost_ = 0, crossings_ = 0;
};

}  // namespace wuerfel
