/// The second half of a step: the velocity nearest to that after the first half that closes no gap, by the impact law over
/// all that touches where the cubes have come.
#pragma once

#include <vector>

#include "core/time/stepping/overlap_removal.h"
#include "core/time/stepping/resting_islands.h"
#include "core/time/stepping/stride.h"

namespace wuerfel {

class Landing {
 public:
  /// `removal` knows the start of the step.
  Landing(Workspace& work, OverlapRemoval& removal, RestingIslands& resting);
  /// Contacts at the end of the way: what touches there, and what was pressed and is still near.
  void find_touching(Stride& stride, Bookkeeping& book);
  [[nodiscard]] const std::vector<Contact>& touching() const { return contacts_; }
  /// Velocities of `state` after the second half, whose impulses are put into the stride.
  void strike(State& state, Bookkeeping& book);

 private:
  void strike_anew(State& state);
  void take_back(const std::vector<Contact>& contacts, State& state);
  [[nodiscard]] bool is_faster_than_free(const Island& island, const State& state) const;
  void hit(State& state, Bookkeeping& book);
  bool rests(const Island& island, State& state);

  const System* system_;
  Workspace* work_;
  OverlapRemoval* removal_;
  RestingIslands* resting_;
  Stride* stride_ = nullptr;
  std::vector<Contact> contacts_;
  std::vector<Island> islands_;  ///< of these
};

}  // namespace wuerfel
