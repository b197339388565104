/// Semismooth Newton from known modes [Alart, Curnier 1991], here with one modes' linear piece per
/// step and the proximal compliance of ModeSystem. One factorisation where the modes are right; it
/// need not end from wrong ones.
///
/// Compliance counts from the same forces until modes are confirmed, and then from those found there:
/// proximal steps [Rockafellar 1976a]. Wrong modes of redundant contacts press with what their rows
/// miss over the compliance, so that a large one holds better and a small one ends sooner: it begins
/// with the first and shrinks where proximal steps are slow, and goes on along the last one where the
/// smallest is slow, too.
#pragma once

#include <limits>
#include <vector>

#include "core/qp/coulomb/contact_modes.h"

namespace wuerfel {

struct ModeNewtonEffort {
  double delta = 1e-8;        ///< at first
  double least_delta = 1e-8;  ///< at last
  int most_factorisations = 8;
  int most_no_better =
      5;  ///< of them in a row that changed no fewer modes than the best one before
  /// By which forces may change at once where nothing resists them: the law is judged relative to the
  /// largest, which could grow until everything is right.
  double most_force = unbounded;
};

struct ModeNewtonOutcome {
  bool settled = false;  ///< modes confirmed and rows within the goal
  int factorisations = 0;
};

class ModeNewton {
 public:
  ModeNewtonOutcome run(ContactForm& form,
                        std::vector<ContactMode>& modes,
                        ContactPoint& point,
                        const ModeNewtonEffort& effort);

 private:
  /// Since modes were confirmed.
  struct Search {
    std::vector<std::vector<ContactMode>> visited;
    int fewest = std::numeric_limits<int>::max();  ///< modes revised at a step
    int no_better = 0;                             ///< steps in a row that revised no fewer
  };
  enum class End { moved, slow, stuck, settled };
  struct ProximalSteps {
    End end = End::stuck;
    int revised = 0;  ///< modes that moved
  };
  ProximalSteps take_proximal_steps(const ContactForm& form,
                                    std::vector<ContactMode>& modes,
                                    ContactPoint& point,
                                    const ModeNewtonEffort& effort);
  End extrapolate(const ContactForm& form,
                  std::vector<ContactMode>& modes,
                  ContactPoint& point,
                  double most,
                  double most_force);
  bool gets_on(const std::vector<ContactMode>& modes, int revised, int most);
  void step(const ContactForm& form, ContactPoint& point);
  void finish(const ContactForm& form, double missed, ContactPoint& point);
  bool find_unbalance(const ContactForm& form, const ContactPoint& point);
  void find_missing(const ContactForm& form, const ContactPoint& point);

  ModeSystem system_;
  double delta_ = 0.0;
  std::vector<Pair> centre_;  ///< forces from which compliance counts
  Search search_;
  std::vector<Pair> missing_;  ///< of the rows, compliance included
  std::vector<Quad> unbalance_;
};

/// Moves each contact to the mode its forces and velocities (-rest) ask for; how many moved. `noise`
/// is the share of the largest force and velocity that counts as zero.
int revise_modes(const ContactForm& form,
                 const std::vector<Pair>& l,
                 const std::vector<Pair>& rest,
                 double noise,
                 std::vector<ContactMode>& modes);

}  // namespace wuerfel
