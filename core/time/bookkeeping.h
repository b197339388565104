/// What a run keeps book of: events, invariants, cost.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/dynamics/push.h"
#include "core/geometry/vec2.h"

namespace wuerfel {

struct IslandSolution;
struct MomentumScale;
struct Solves;

enum class EventKind { impact, touch, release, slide_off, stick, slip, jam, rest };
std::string_view to_string(EventKind kind);

/// Something that happened at one instant.
struct Event {
  double t = 0.0;  ///< s
  EventKind kind = EventKind::impact;
  std::string on;             ///< body the impulse acts on
  std::string from;           ///< body it comes from
  Vec2 point = Vec2::Zero();  ///< m
  double impulse = 0.0;       ///< N s
};

/// Energy that was taken at one instant, or in the course of some time up to it.
struct Loss {
  double t = 0.0;         ///< s
  double energy = 0.0;    ///< J
  bool friction = false;  ///< taken by friction
  double since = 0.0;     ///< s, t where it was taken at once
};

/// What a run promises of itself.
enum class Promise { programs, events, friction, overlap, energy, momentum, rods };
std::string_view to_string(Promise promise);

/// A promise that was broken: within the step that begins at t, by one of these bodies.
struct Breach {
  Promise promise = Promise::programs;
  double t = 0.0;  ///< s
  std::vector<std::string> bodies;
};

/// Invariants kept book of in every run.
struct Audit {
  double max_penetration = 0.0;   ///< m, deepest overlap of any pair at any step end
  double max_overlap = 0.0;       ///< the same as a share of the smaller side of the pair
  double max_rod_error = 0.0;     ///< largest relative change of a rod's length
  double max_kkt_residual = 0.0;  ///< worst optimality residual of any program that was used
  long missed_solves = 0;         ///< programs whose residual missed the tolerance
  /// Times at which cubes had to stop short at the end of a step to leave no overlap, or at its start to make no energy or tear no rod.
  long unresolved = 0;
  long searches_given_up = 0;  ///< event searches that left a gap near zero unproved; overlap is
                               ///< measured afterwards
  /// Programs without any solution, and accelerations that no step can follow: cubes wedged by
  /// their turning.
  long wedged = 0;
  long rods_contradicting = 0;     ///< times at which no accelerations kept the lengths of all rods
  long friction_inexact = 0;       ///< programs in which Coulomb's law was missed
  double friction_residual = 0.0;  ///< the worst residual of Coulomb's law
  long restitution_reduced = 0;    ///< impacts whose coefficients had to be scaled back
  double drift_budget = 0.0;   ///< J, what the tolerance promises of |drift()|; 0 where it promises
                               ///< nothing (stepping)
  double energy_start = 0.0;   ///< J
  double energy_end = 0.0;     ///< J
  double impact_loss = 0.0;    ///< J, taken by impacts
  double friction_loss = 0.0;  ///< J
  // The largest change of the momenta of all cubes that neither gravity nor fixed bodies account for,
  // as a share of MomentumScale (core/dynamics/momentum_balance.h).
  double momentum_linear = 0.0;
  double momentum_angular = 0.0;
  /// The sum of what fixed bodies gave beyond the impulses of programs, where steps put energy and
  /// gaps right; a share of the same.
  double momentum_settled = 0.0;
  double momentum_budget = 0.0;  ///< what the method promises of the first two; 0: nothing yet
  double settled_budget = 0.0;   ///< and of the third, up to now
  [[nodiscard]] double drift() const {
    return energy_end + impact_loss + friction_loss - energy_start;
  }
};

/// Notes the deepest overlap of a state: depth in m, and the smaller side of the pair.
void note_overlap(double depth, double side, Audit& audit);

struct Cost {
  long steps = 0;
  long qp_solves = 0;
  long qp_iterations = 0;  ///< of the solvers
  long hand_overs = 0;     ///< times at which events crowded and stepping took over
  // Programs answered without a solver, by the reason (Skips in core/settings.h).
  long skipped_free = 0;         ///< cubes that touch nothing
  long skipped_rest = 0;         ///< islands in certified rest
  long skipped_certificate = 0;  ///< islands whose former answer still passed
  [[nodiscard]] long qp_skipped() const {
    return skipped_free + skipped_rest + skipped_certificate;
  }
};

Cost sum_of(const Cost& a, const Cost& b);

struct Bookkeeping {
  std::vector<Event> events;
  std::vector<Loss> losses;
  Audit audit;
  Cost cost;
  std::vector<Breach> breaches;
  Push settled;      ///< by fixed bodies, where steps put energy and gaps right
  Push unexplained;  ///< changes of the momenta of the cubes that nothing accounts for, up to now
};

/// Adds what was booked of a part, or of a stretch, of the motion.
void add(const Bookkeeping& more, Bookkeeping& book);

/// Audits what is unexplained up to now, as shares of the scale.
void note_unexplained(const MomentumScale& scale, Bookkeeping& book);

/// Sorts by time what came after the first events and losses; what happened at one time keeps its order.
void sort_by_time(std::size_t events, std::size_t losses, Bookkeeping& book);

/// Books programs that were solved, and how well; or only what they cost, where the answer is judged
/// by what it leads to.
void keep_cost(const Solves& solves, Bookkeeping& book);
void keep_book(const Solves& solves, Bookkeeping& book);
void keep_book(const IslandSolution& solution, Bookkeeping& book);

}  // namespace wuerfel
