/// Keeps cubes apart within a step: what does not fit is moved by the least that makes it fit.
#pragma once

#include <span>
#include <vector>

#include "core/dynamics/projection.h"
#include "core/model/scales.h"
#include "core/time/bookkeeping.h"
#include "core/time/stepping/near_contacts.h"
#include "core/time/stepping/stride.h"
#include "core/time/workspace.h"

namespace wuerfel {

/// Overlap that steps may leave, as a share of the smaller side of a pair.
inline constexpr double overlap_share = 2e-10;

/// Pairs that come nearer to each other than this share of the smaller side may be pushed into each
/// other within a step.
inline constexpr double near_share = 1e-2;

/// How exactly the programs of a step are solved: it is as exact as its length allows, not as its
/// programs are. Steps of Newton's method only have to get out of the overlap, but where bodies rub what rests is to be left
/// where it is: a solution in the inside opens all gaps of its island, and what held has to find its hold anew.
ProgramTolerances step_tolerances(const System& system);

class OverlapRemoval {
 public:
  explicit OverlapRemoval(Workspace& work)
      : system_(work.system), work_(&work), near_(*work.system) {}

  /// A step of `h` s begins at a state without overlap.
  void begin(const State& start, double h);
  [[nodiscard]] NearContacts& near() { return near_; }

  /// An island whose contacts may not overlap, with what is kept open of their gaps.
  [[nodiscard]] Restricted apart(Island island) const;
  /// To the nearest place without overlap where rods have their lengths; each pair is kept apart by the side that did so longest on
  /// the way from the start. Returns the contacts that pushed. Judged by the overlap that is left in
  /// the end, not by the residuals of its programs.
  std::vector<Contact> clean_up(State& state, Bookkeeping& book);
  /// Halves the ways that cubes have come from the start, with all that is near them, until nothing
  /// overlaps.
  void retreat(State& state);

  /// Finds contacts with gaps up to `tolerance` (a share of the smaller side); the deepest overlap.
  double measure(const State& state, double tolerance);
  /// Deepest overlap where the last `clean_up` or `retreat` ended, as a share of the smaller side of
  /// the pair.
  [[nodiscard]] double left() const { return left_; }
  /// What touches there, which depends on velocities where corners meet corners.
  [[nodiscard]] const std::vector<Contact>& touching() const { return found_; }

 private:
  [[nodiscard]] double margin(const Contact& c, double move) const;
  [[nodiscard]] std::vector<Restricted> pushed_apart(const State& state);
  [[nodiscard]] bool keeps_lengths(const State& state, std::span<const int> rods) const;
  [[nodiscard]] bool keeps_lengths(const State& state) const;
  [[nodiscard]] std::vector<char> overlapping_cubes() const;

  const System* system_;
  Workspace* work_;
  NearContacts near_;
  Scales scales_;
  double h_ = 0.0;     ///< s, of the step
  double left_ = 0.0;  ///< of the smaller side
  State start_;
  std::vector<Contact> found_;  ///< at the last measurement
};

}  // namespace wuerfel
