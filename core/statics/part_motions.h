/// Motions of parts of a pile that no contact hinders.
#pragma once

#include <vector>

#include "core/statics/generators.h"
#include "core/statics/load_factor.h"
#include "core/statics/loads.h"

namespace wuerfel {

/// Motions of one part that no contact hinders, about a point where it is held or to the side. Each is
/// a cut for any load, and in plain stacks the one that counts.
class PartMotions {
 public:
  PartMotions(const StillScene& still, const Island& island, const Generators& generators);

  /// The least s that one of them cuts off w + s q.
  [[nodiscard]] KnownCut cut(const Load& w, const Load& q) const;

 private:
  struct Motion {
    int part = 0;
    Vec2 center = Vec2::Zero();  ///< m, where `twist` is that of the part
    Twist twist;
  };
  /// `rows_of`: of contacts, per place of a cube; `rods`: the other rows.
  void add_of_part(int part,
                   const Generators& generators,
                   const std::vector<std::vector<int>>& rows_of,
                   const std::vector<int>& rods);
  void add(const Motion& motion, const std::vector<int>& rows, const QuadraticProgram& program);
  [[nodiscard]] Twist of_cube(const Motion& motion, int place) const;
  [[nodiscard]] double power(const Motion& motion, const Load& load) const;

  const StillScene* still_;
  const Island* island_;
  std::vector<double> mass_;             ///< of the unknowns
  std::vector<std::vector<int>> parts_;  ///< places of the cubes in the island
  std::vector<Motion> motions_;
};

}  // namespace wuerfel
