/// The order in which blocks are eliminated: approximately the one of least fill.
#pragma once

#include <vector>

namespace wuerfel {

/// Fills `order` with the blocks 0 .. blocks-1 in the order of elimination. `neighbour[start[b]] ..
/// neighbour[start[b+1]-1]` are the blocks coupled to b, increasing, each coupling listed at both.
/// Minimum degree: exact up to 64 blocks (without allocation once `order` has grown), else
/// approximate [Amestoy, Davis, Duff 1996], as in Eigen.
void elimination_order(int blocks,
                       const std::vector<int>& start,
                       const std::vector<int>& neighbour,
                       std::vector<int>& order);

}  // namespace wuerfel
