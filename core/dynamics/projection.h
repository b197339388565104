/// Projection: the nearest place, in the metric of the masses, where contacts that stay closed are
/// closed and nothing overlaps, and the nearest velocities that keep them closed ("eventuell
/// Längenkorrektur"). Newton's method: each round solves one program per island, linear in the
/// displacements, from where the round before has led [Hairer, Lubich, Wanner 2006, IV.4].
///
/// Nothing is written but the answer: the caller takes it over, and keeps book.
#pragma once

#include <functional>
#include <limits>

#include "core/dynamics/closed_contacts.h"
#include "core/dynamics/solves.h"

namespace wuerfel {

/// Share of contact_scale: gaps and overlap smaller than this are none after a projection. Well inside
/// touching_tolerance, well above rounding.
inline constexpr double closed_gap = 1e-11;

/// What cubes are projected onto: contacts as they are at the state, and how each restricts them.
struct Restricted {
  Island island;
  std::vector<SideUse> use;       ///< equality: no gap; inequality: no overlap
  std::vector<double> margins{};  ///< m, gaps to be kept where there is room; empty: none
  /// m; who had to move farther than this is not near any place that is allowed.
  double farthest = std::numeric_limits<double>::infinity();
};

/// What becomes of an island whose restrictions contradict one another, to first order.
enum class Contradiction {
  take,   ///< as near as the solver comes
  leave,  ///< it stays where it is
  open,   ///< closed contacts may open; what overlaps is removed
};

/// An island is moved where it misses its restrictions by more than this, or a rod its length by more
/// than rounding.
struct ProjectionPolicy {
  double overlap = std::numeric_limits<double>::infinity();  ///< of contact_scale
  double gap = std::numeric_limits<double>::infinity();      ///< likewise, of closed contacts
  int rounds = 1;                                            ///< of Newton's method, at most
  Contradiction contradiction = Contradiction::take;
};

/// Whether an island is to be moved.
bool misses(const System& system,
            const State& state,
            const Restricted& part,
            const ProjectionPolicy& policy);
/// Whether the closed contacts neither close nor open, and rods keep their lengths, as it is.
bool rests(const System& system, const State& state, const Restricted& part);

struct [[nodiscard]] Projection {
  State state;
  bool moved = false;              ///< somebody was
  bool too_far = false;            ///< it ended where an island would have moved too far
  int rounds = 0;                  ///< that were made
  std::vector<Contact> pushing{};  ///< those that bore a part of it without being closed
  std::vector<Contact> opened{};   ///< of islands whose closed contacts had to open
  Solves solves{};                 ///< answers that were not taken count as cost
};

/// What restricts the cubes where they have come. None: the projection is over.
using FindRestricted = std::function<std::vector<Restricted>(const Projection& so_far)>;

/// Places; velocities stay what they are.
Projection project_places(const System& system,
                          State state,
                          const ProjectionPolicy& policy,
                          const FindRestricted& find,
                          IslandDynamics& dynamics);

/// Velocities: gaps of closed contacts stay as they are, no other closes. An island whose closed
/// contacts rest and whose rods keep their lengths is left alone.
Projection project_velocities(const System& system,
                              State state,
                              const std::vector<Restricted>& parts,
                              Contradiction contradiction,
                              IslandDynamics& dynamics);

/// Where nothing is asked for but that all contacts stay closed, as within a smooth phase: a round is
/// one linear system, whose factorisation the contacts keep.
void project_places(ClosedContacts& closed, State& state);
void project_velocities(ClosedContacts& closed, State& state);

/// One round of an island: displacements to the place nearest to `targets` (one per cube; none: to
/// where it is). With margins, or without where there is no room for them; `unused` counts what the
/// first try cost.
IslandSolution nearest_place(const State& state,
                             const Restricted& part,
                             std::span<const Twist> targets,
                             IslandDynamics& dynamics,
                             Solves& unused);
/// Whether a contact, or one of an island, overlaps by more than a share of contact_scale.
bool overlaps(const System& system, const Contact& contact, double share);
bool overlaps(const System& system, const Island& island, double share);
/// The island with its gaps less the margins.
Island with_margins(const Restricted& part);
/// The same corners and sides as they are at a state.
void follow(const System& system, const State& state, std::vector<Contact>& contacts);

}  // namespace wuerfel
