/// The row of a rod or of one coordinate of a pin: Eq. (1) of its two places, divided by the rod's length so that the
/// multiplier is a force, and pulled back to the bodies by the chain rule. With the direction u from place j to place i
///
///     |p_i - p_j| - l_ij = 0,   <v_i - v_j, u> = 0,   <a_i - a_j, u> + |v_i - v_j|^2 / l_ij = 0
///
/// and the same of a pin with u fixed and l_ij = 0. A multiplier nu is the force nu u on the body of p_i: tension is -nu.
#pragma once

#include <array>

#include "core/constraints/rod.h"
#include "core/dynamics/contact_rows.h"

namespace wuerfel {

/// A place of a rod as it is now.
struct HeldPlace {
  Vec2 arm = Vec2::Zero();  ///< m, from the centre of the body; zero where fixed
  Vec2 p = Vec2::Zero();    ///< m
  Vec2 v = Vec2::Zero();    ///< m/s
};
HeldPlace held_place(const RodEnd& end, const State& state);

/// <g_i, x_i> + <g_j, x_j> + c = 0 in the rates (x, y, theta) of the bodies.
struct BodyRodRow {
  std::array<double, 3> i{};  ///< zeros for what is fixed
  std::array<double, 3> j{};  ///< likewise
  double c = 0.0;  ///< the length's error (m), 0 (m/s), or what no acceleration changes (m/s^2)
};

/// On the two places; g is a unit vector.
RodRow rod_row(const Rod& rod, const HeldPlace& i, const HeldPlace& j, Order order);
/// On the bodies that carry them.
BodyRodRow rod_row(const Rod& rod, const State& state, Order order);

/// Direction of the multiplier's force on the body of place i, a unit vector.
Vec2 rod_direction(const Rod& rod, const State& state);
/// How much longer a rod is than it should be, m; of a pin how far its places are apart.
double rod_excess(const Rod& rod, const State& state);
/// Rate of that, m/s.
double rod_rate(const Rod& rod, const State& state);
/// How much longer a rod gets, m, to first order, by displacements that are the velocities of `moved`.
double rod_change(const Rod& rod, const State& place, const State& moved);
/// Relative change of the length of a rod between bodies; of a pin how far its places are apart in parts of the
/// smaller side of its cubes (of a metre between points).
double rod_error(const System& system, const State& state, const Rod& rod);
/// The largest of them.
double largest_rod_error(const System& system, const State& state);

/// Whether a rod has its length, but for rounding.
bool has_length(const System& system, const State& state, const Rod& rod);

/// Name of the body at an end of a rod; where that is a place of the world, the rod's.
const std::string& end_name(const System& system, const Rod& rod, const RodEnd& end);

/// Whether velocities change a rod's length by more than rounding, so that they have to jump.
bool jerks(const System& system, const State& state, const Rod& rod);

}  // namespace wuerfel
