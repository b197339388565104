/// What every run promises, and who broke it first.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/geometry/box.h"
#include "core/time/bookkeeping.h"

namespace wuerfel {

/// Largest share of the smaller side of a pair by which bodies may overlap (and a little for
/// rounding).
inline constexpr double promised_overlap = 1.01 * touching_tolerance;
/// Largest share of its length by which a rod may miss it.
inline constexpr double promised_rod_error = 1e-9;
/// Residual of Coulomb's law that is counted but borne.
inline constexpr double promised_friction = 1e-6;
/// Share by which momenta may change without a reason, and the same where steps were taken.
inline constexpr double promised_momentum = 1e-5;
inline constexpr double promised_momentum_of_steps = 1e-4;
/// And where steps are of the first order: moving bodies out of overlap turns momenta about the centre.
inline constexpr double promised_momentum_of_first_order = 1e-2;
/// Share of the momenta that fixed bodies may give beyond the impulses of programs, times 1 + t V / L, which is what weights
/// do meanwhile: from event to event; where steps were taken; where these bounce; and where they are of the first order.
inline constexpr double promised_settled = 1e-3;
inline constexpr double promised_settled_of_steps = 1e-2;
inline constexpr double promised_settled_of_bounces = 1e-1;
inline constexpr double promised_settled_of_first_order = 1.0;
constexpr double promised_settled_in_steps(bool bounces) {
  return bounces ? promised_settled_of_bounces : promised_settled_of_steps;
}

/// The promises that an audit of a stretch of the motion shows as broken, the gravest first.
std::vector<Promise> broken_promises(const Audit& audit);

/// Books the promises that were broken since `before`, first by these bodies at time t.
void note_breaches(const Audit& before,
                   double t,
                   std::span<const std::string> bodies,
                   Bookkeeping& book);

/// The first breach of a promise; none: nullptr.
const Breach* first_breach(const std::vector<Breach>& breaches, Promise promise);

}  // namespace wuerfel
