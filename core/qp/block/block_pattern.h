/// The pattern of the factors of sparse symmetric patterns of 3x3 blocks: which blocks of L are filled,
/// column by column and row by row. Symbolic work only, done once while couplings stay the same.
/// [Davis 2006] ch. 4
#pragma once

#include <vector>

namespace wuerfel {

struct BlockPattern {
  int blocks = 0;
  std::vector<int> column_start{0};  ///< column j: row[column_start[j] .. column_start[j + 1] - 1]
  std::vector<int> row;              ///< ascending, the diagonal first
  // Row i below the diagonal: column list_column[l] at place list_place[l] of `row`, l from
  // list_start[i] to list_start[i + 1] - 1.
  std::vector<int> list_start, list_column, list_place;

  /// For matrices whose blocks are coupled where `neighbour` says so (as in elimination_order).
  /// `order` becomes the order of elimination, in which all that follows is numbered.
  void plan(int count,
            const std::vector<int>& start,
            const std::vector<int>& neighbour,
            std::vector<int>& order);
  /// Place of block (row, column), row >= column; -1 if it is not in the pattern.
  [[nodiscard]] int place(int i, int column) const;
  /// Number of blocks of L.
  [[nodiscard]] int fill() const { return column_start.back(); }

 private:
  void find_columns(const std::vector<int>& start,
                    const std::vector<int>& neighbour,
                    const std::vector<int>& order);
  void list_rows();

  std::vector<int> position_, mark_, first_child_, next_sibling_;  ///< scratch
};

}  // namespace wuerfel
