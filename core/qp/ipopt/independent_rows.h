/// Which of many rows carry information: a largest set of linearly independent ones.
#pragma once

#include <vector>

#include <Eigen/Dense>

namespace wuerfel {

/// A sparse row: its entries in increasing columns.
struct SparseRow {
  std::vector<int> columns;
  std::vector<double> values;
};

/// Marks a largest linearly independent subset of `rows` (of unit length, or zero). Found by
/// Householder QR with pivoting in every connected component; a pivot below `tolerance` ends a
/// component. Cost: cubic in the largest component.
std::vector<bool> independent_rows(const std::vector<SparseRow>& rows,
                                   int columns,
                                   double tolerance = 1e-10);

}  // namespace wuerfel
