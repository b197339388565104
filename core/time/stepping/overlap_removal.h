/// Keeps cubes apart within a step: what does not fit is moved by the least that makes it fit.
#pragma once

#include <span>
#include <vector>

#include "core/dynamics/gauss.h"
#include "core/model/scales.h"
#include "core/time/bookkeeping.h"
#include "core/time/stepping/near_contacts.h"

namespace wuerfel {

/// Overlap that steps may leave, as a share of the smaller side of a pair.
inline constexpr double overlap_share = 2e-10;

class OverlapRemoval {
 public:
  OverlapRemoval(const System& system, const MotionSettings& settings);

  /// A step of `h` s begins at a state without overlap.
  void begin(const State& start, double h);
  [[nodiscard]] NearContacts& near() { return near_; }

  /// Displacements from `state` that leave no overlap of the island's contacts, to first order,
  /// nearest to `targets` (one per cube) or to none. Judged by the overlap that is left in the end,
  /// not by its residual.
  IslandSolution apart(Island island,
                       const State& state,
                       std::span<const Twist> targets,
                       Bookkeeping& book);
  /// The island with its gaps less what is kept open.
  [[nodiscard]] Island with_margins(Island island) const;
  /// Newton's method towards the nearest place without overlap; each pair is kept apart by the side
  /// that did so longest on the way from the start. Adds the contacts that pushed to `pushing`.
  void clean_up(State& state, std::vector<Contact>& pushing, Bookkeeping& book);
  /// Halves the ways that cubes have come from the start, with all that is near them, until nothing
  /// overlaps.
  void retreat(State& state);

  /// Deepest overlap of a state, as a share of the smaller side of the pair.
  double measure(const State& state);
  /// The same where the last `clean_up` or `retreat` ended.
  [[nodiscard]] double left() const { return left_; }

 private:
  [[nodiscard]] double margin(const Contact& c, double overlap) const;
  [[nodiscard]] std::vector<double> margins_of(const Island& island) const;
  [[nodiscard]] std::vector<char> overlapping_cubes() const;

  const System* system_;
  IslandDynamics dynamics_;
  NearContacts near_;
  ContactFinder finder_;
  Scales scales_;
  double h_ = 0.0;     ///< s, of the step
  double left_ = 0.0;  ///< of the smaller side
  State start_;
  std::vector<Contact> contacts_;
  std::vector<Contact> overlapping_;
  std::vector<Island> islands_;
  std::vector<SideUse> use_;
};

}  // namespace wuerfel
