/// Semismooth Newton from known modes. [Alart, Curnier 1991] P. Alart, A. Curnier, A mixed
/// formulation for frictional contact problems prone to Newton like solution methods, Comput.
/// Methods Appl. Mech. Engrg. 92; here with one modes' linear piece per step and the proximal
/// compliance of ModeSystem. One factorisation where the modes are right; it need not end from wrong
/// ones.
#pragma once

#include <vector>

#include "core/qp/coulomb/contact_modes.h"

namespace wuerfel {

struct ModeNewtonEffort {
  double delta = 1e-8;
  Pivoting pivoting = Pivoting::none;
  double goal = 1e-12;  ///< what rows in force may miss, relative to the largest velocity
  int most_factorisations = 8;
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
  double step(const ContactForm& form, const std::vector<ContactMode>& modes, ContactPoint& point);

  ModeSystem system_;
  std::vector<Quad> unbalance_;
};

/// Moves each contact to the mode its forces and velocities ask for; how many moved. `noise` is the
/// share of the largest force and velocity that counts as zero.
int revise_modes(const ContactForm& form,
                 const ContactPoint& point,
                 double noise,
                 std::vector<ContactMode>& modes);

}  // namespace wuerfel
