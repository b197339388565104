/// Which forces are possible in an island: programs over all that give it the accelerations it has.
#pragma once

#include <array>
#include <vector>

#include "core/statics/generators.h"
#include "core/statics/loads.h"
#include "core/statics/ranges.h"

namespace wuerfel {

/// The forces of one island that give it the accelerations it has.
class IslandRanges {
 public:
  IslandRanges(const StillScene& still, const IslandForces& of);

  /// Of the sum of normal forces at these contacts, N.
  LoadRange force(const std::vector<int>& contacts);
  /// Of the centre of pressure of these contacts, at `place` (m) each.
  LoadRange center(const std::vector<int>& contacts, const std::vector<double>& place);
  /// Of hyperstaticity; flush sides, of which these are the contacts, have one tangential force.
  [[nodiscard]] int degree(const std::vector<std::vector<int>>& faces);

 private:
  void drop_what_departs();
  [[nodiscard]] bool may_carry(int row);
  [[nodiscard]] double slip(const Contact& contact) const;
  void balance();
  QuadraticProgram with_block(const std::vector<std::array<double, 3>>& of_rows) const;
  LoadRange sum(const std::vector<double>& of_rows);

  const StillScene& still_;
  const IslandForces& of_;
  Generators generators_;
  std::vector<char>
      used_;           ///< per row: not of a contact that opens, nor of an edge it slips away from
  Load load_;          ///< what the forces carry
  double unit_ = 1.0;  ///< N
  double mass_ = 1.0;  ///< kg
};

}  // namespace wuerfel
