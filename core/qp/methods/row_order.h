/// In which order rows are eliminated, so that the factor stays narrow.
#pragma once

#include <vector>

namespace wuerfel {

/// Rows of a program and the blocks that they have entries on.
struct RowsOnBlocks {
  const std::vector<int>& row;          ///< rows of the program; these are numbered 0, 1, ..
  const std::vector<int>& row_start;    ///< of the program: where entries of a row begin
  const std::vector<int>& entry_block;  ///< of the program: block of an entry
  const std::vector<std::vector<int>>& rows_of_block;  ///< by number in `row`
};

/// Reverse Cuthill-McKee order [George, Liu 1981, ch. 4]: neighbours, which share a block, get numbers
/// close to each other. Writes rows of the program into `order`.
void find_row_order(const RowsOnBlocks& rows, std::vector<int>& order);

}  // namespace wuerfel
