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

  // All of them may be asked by several threads at once.

  /// Of the sum of normal forces at these contacts, N, of which one is `known`; empty where that is outside.
  [[nodiscard]] LoadRange force(const std::vector<int>& contacts, double known) const;
  /// Of the centre of pressure of these contacts, at `place` (m) each.
  [[nodiscard]] LoadRange center(const std::vector<int>& contacts,
                                 const std::vector<double>& place) const;
  /// Rows of the program, and whether any of the possible forces has a part along one.
  [[nodiscard]] int rows() const { return generators_.program.rows(); }
  [[nodiscard]] bool may_carry(int row) const;
  /// Of hyperstaticity, where these rows may carry; flush sides, of which these are the contacts, have one tangential force.
  [[nodiscard]] int degree(const std::vector<char>& carries,
                           const std::vector<std::vector<int>>& faces) const;

 private:
  void drop_what_departs();
  [[nodiscard]] double slip(const Contact& contact) const;
  void balance();
  [[nodiscard]] QuadraticProgram with_block(
      const std::vector<std::array<double, 3>>& of_rows) const;
  [[nodiscard]] LoadRange sum(const std::vector<double>& of_rows) const;

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
