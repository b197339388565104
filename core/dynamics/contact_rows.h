/// The rows of a contact, for programs, equations of motion and everything else that restricts or
/// measures how the corner p_k moves against the side (p_i, p_j): along the normal, Eq. (6) and (7),
/// and along the side. Written once on the three points (constraints/side.h), divided by the side's
/// length so that a multiplier is a force, and pulled back to the cubes by the chain rule.
#pragma once

#include <array>

#include "core/constraints/contact.h"
#include "core/constraints/side.h"

namespace wuerfel {

/// What is restricted: displacements (m, rad), velocities (m/s, rad/s) or accelerations.
enum class Order { position, velocity, acceleration };

/// <on, x_on> + <from, x_from> + c in the rates (x, y, theta) of the bodies of corner and side.
struct ContactRow {
  std::array<double, 3> on{};    ///< zeros for what is fixed
  std::array<double, 3> from{};  ///< likewise
  double c = 0.0;
};

/// On points. Value: the gap after a displacement (m), its rate (m/s) or its second rate (m/s^2),
/// the latter where gap and rate are zero.
SideRow normal_row(const System& system, const State& state, const Contact& contact, Order order);
/// On points, along perp(contact.normal). Value: how far the corner is displaced against the place of
/// the side where it is (m), how fast it slides (m/s), or the rate of that in the frame of the side
/// (m/s^2).
SideRow tangential_row(const System& system,
                       const State& state,
                       const Contact& contact,
                       Order order);

/// How fast the corner slides along perp(contact.normal) against the side, m/s.
double slip_rate(const System& system, const State& state, const Contact& contact);

/// A row on points as one on the bodies that carry them.
ContactRow pull_back(const System& system,
                     const State& state,
                     const Contact& contact,
                     Order order,
                     const SideRow& row);

}  // namespace wuerfel
