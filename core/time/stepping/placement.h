/// The first half of a step: the place nearest to free flight where nothing overlaps and rods have their lengths, with
/// contact forces along the directions of the step's start, and the impulses that lead there.
#pragma once

#include <vector>

#include "core/time/stepping/overlap_removal.h"
#include "core/time/stepping/resting_islands.h"
#include "core/time/stepping/stride.h"

namespace wuerfel {

class Placement {
 public:
  /// `removal` knows the start of the step.
  Placement(Workspace& work, OverlapRemoval& removal, const RestingIslands& resting);
  /// Where the cubes come. Velocities between the halves, impulses and blows of the first half are put into the stride.
  State find(Stride& stride, Bookkeeping& book);

 private:
  void rest(const RestingIsland& island, State& state);
  void place_island(const Island& island, State& state, Bookkeeping& book);
  IslandSolution apart(const Island& island,
                       const std::vector<Twist>& targets,
                       bool again,
                       Bookkeeping& book);
  void bend(const Island& island,
            const std::vector<Twist>& targets,
            const IslandSolution& straight,
            State& state,
            Bookkeeping& book);
  void note_way(const Island& island, const State& state);
  bool bend_rods(const State& end, Island& bent) const;
  bool bend_more(const State& end, Island& bent) const;
  [[nodiscard]] double worst_of(const State& state, const std::vector<int>& rods) const;
  void fly_half(const Island& island, const IslandSolution& solution, State& state);
  void note_pressed(const Island& island, const IslandSolution& solution);

  const System* system_;
  Workspace* work_;
  OverlapRemoval* removal_;
  const RestingIslands* resting_;
  Stride* stride_ = nullptr;
  /// Where cubes have come in the first placement, and a state whose velocities are their displacements: what rows
  /// times a displacement are read from.
  struct Way {
    std::vector<Box> boxes;
    State moved;
  };
  Way way_;
};

}  // namespace wuerfel
