/// Seeded programs of all kinds that stacks, walls and piles of squares lead to, for tests and
/// benchmarks of solvers.
///
/// Contacts have unit normals; bodies three unknowns (x, y, angle). With gravity the target is (0,
/// -9.81, 0), at velocity level it is random. All have the solution x = 0 or a feasible point near
/// it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/qp/quadratic_program.h"
#include "core/scene/counter_random.h"

namespace wuerfel::test {

/// A small generator with the same numbers everywhere.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : seed_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * random_unit(seed_, count_++);
  }
  int below(int count) {
    return static_cast<int>(random_bits(seed_, count_++) % static_cast<std::uint64_t>(count));
  }

 private:
  std::uint64_t seed_;
  std::uint64_t count_ = 0;
};

enum class Masses { equal, random_to_1e6, alternating_1e6 };

/// How a program departs from its ideal geometry.
struct ZooOptions {
  double shift = 0.0;  ///< positions of contacts, uniform in +-shift
  double turn = 0.0;   ///< directions of normals, rad, uniform in +-turn
  Masses masses = Masses::equal;
  bool velocity = false;  ///< random velocities instead of gravity
  int copies = 1;         ///< of every row, scaled at random
  std::uint64_t seed = 1;
  std::uint64_t step = 0;  ///< another departure from the same geometry
};

/// Squares on each other, each off by up to 0.05: two rows per interface.
QuadraticProgram tower(int count, const ZooOptions& options = {});
/// Running bond with half bricks at the ends and two contacts on every face, side faces too:
/// hyperstatic.
QuadraticProgram wall(int layers, int columns, const ZooOptions& options = {});
/// Layers of `layers`, layers - 1, .. 1 squares, each on two.
QuadraticProgram pyramid(int layers, const ZooOptions& options = {});
/// A jittered lattice of tilted bodies, about 2.4 contacts per body.
QuadraticProgram pile(int count, const ZooOptions& options = {});

struct ZooProgram {
  std::string name;
  QuadraticProgram program;
};

/// Number `index` of an endless row of small and middle-sized programs of all the kinds above, up
/// to about 60 bodies.
ZooProgram random_program(int index);

}  // namespace wuerfel::test
