/// Impulses at contacts, and what they may not change: momentum and angular momentum, to rounding. Velocities are
/// read from impulses, never from the unknowns of a program, which are only as exact as it was solved.
#pragma once

#include <span>
#include <vector>

#include "core/constraints/islands.h"

namespace wuerfel {

/// From the centre of the body of the side to the place of the corner p_k, m.
Vec2 arm_of_side(const Contact& contact);

/// Velocity of the corner p_k against the body of the side at the same place, m/s: what an impulse there works on. (Of the
/// side's own points: contact_velocity.)
Vec2 relative_velocity(const System& system, const State& state, const Contact& contact);

/// Changes velocities by an impulse (N s) on the corner p_k and its opposite on the body of the side at the same
/// place, so that neither sum of momenta nor of angular momenta changes.
void push(const System& system, const Contact& contact, const Vec2& impulse, State& state);

/// The same of an impulse (N s) on place i of a rod and its opposite on place j; they act along one line, of the rod as
/// it is at `place`.
void push(const System& system, const Rod& rod, double impulse, const State& place, State& state);

/// Sums over some cubes.
struct Momentum {
  double mass = 0.0;           ///< kg
  Vec2 center = Vec2::Zero();  ///< m, of mass
  Vec2 linear = Vec2::Zero();  ///< N s
  double angular = 0.0;        ///< N m s, about `center`
  double inertia = 0.0;        ///< kg m^2, about `center`
};
Momentum momentum_of(const System& system, const State& state, std::span<const int> cubes);
/// The same over all cubes that do not rest (`resting`: one per cube, or empty).
Momentum momentum_of_moving(const System& system,
                            const State& state,
                            std::span<const char> resting);

/// Some cubes moving as one body: changes no gap between them.
struct RigidMotion {
  Vec2 center = Vec2::Zero();    ///< m
  Vec2 velocity = Vec2::Zero();  ///< m/s, of the centre
  double spin = 0.0;             ///< rad/s

  [[nodiscard]] Vec2 at(const Vec2& place) const {
    return point_velocity(Twist{velocity, spin}, place - center);
  }
};
void turn(const System& system, std::span<const int> cubes, const RigidMotion& more, State& state);

/// Where cubes were moved from `before` without regard to their velocities, their angular momentum has changed with
/// their places: each group that these contacts join, and that touches nothing fixed, turns by so much slower as a
/// whole, which changes no gap.
void keep_turning(const System& system,
                  const std::vector<Contact>& contacts,
                  const State& before,
                  State& state);

/// Groups of cubes that rods join, and that nothing fixed holds: neither a rod nor one of these contacts. None of them
/// rests (`resting`: one per cube, or empty).
std::vector<std::vector<int>> flying_groups(const System& system,
                                            const std::vector<Contact>& contacts,
                                            std::span<const char> resting);

/// Some cubes that gravity alone acted on from outside for t s since `from` get the momenta, and the centre of mass, that
/// they had then and gravity leads to: moved and turned as a whole, which changes no gap and no length.
void keep_momenta(
    const System& system, std::span<const int> cubes, const State& from, double t, State& state);

/// Kinetic and potential energy of some cubes, J.
double energy_of(const System& system, const State& state, std::span<const int> cubes);

/// Unit vectors are parallel where their cross product is no more than this.
inline constexpr double parallel = 1e-9;

/// The part of the motion of some cubes that contacts among themselves and with fixed bodies of these normals cannot
/// change: all of their momentum where there is no normal, what is along the bodies where all normals are parallel,
/// else nothing. What is left is orthogonal to it in the mass metric.
RigidMotion kept_motion(const Momentum& momentum, std::span<const Vec2> fixed_normals);

/// Brings the energy of some cubes to `goal` (J) by scaling what is not in `kept` of their velocities; no gap that
/// does not close begins to. Their energy comes as near to it as scaling by 0 .. `most` can. Returns what is still
/// missing, J (negative: too much).
double scale_to_energy(const System& system,
                       std::span<const int> cubes,
                       const RigidMotion& kept,
                       double goal,
                       double most,
                       State& state);

}  // namespace wuerfel
