#include "core/qp/ipopt/independent_rows.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>

namespace wuerfel {
namespace {

int root_of(std::vector<int>& parent, int i) {
  while (parent[i] != i) {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

/// Rows by connected component; rows without entries belong to none.
std::map<int, std::vector<int>> components(const std::vector<SparseRow>& rows, int columns) {
  std::vector<int> parent(columns);
  std::iota(parent.begin(), parent.end(), 0);
  for (const SparseRow& row : rows) {
    for (const int column : row.columns)
      parent[root_of(parent, column)] = root_of(parent, row.columns.front());
  }
  std::map<int, std::vector<int>> result;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].columns.empty())
      result[root_of(parent, rows[i].columns.front())].push_back(static_cast<int>(i));
  }
  return result;
}

/// The rows of one component as the columns of a dense matrix.
Eigen::MatrixXd dense_columns(const std::vector<SparseRow>& rows, const std::vector<int>& members) {
  std::map<int, int> place;
  for (const int i : members) {
    for (const int column : rows[i].columns)
      place.emplace(column, static_cast<int>(place.size()));
  }
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(place.size()),
                                                 static_cast<Eigen::Index>(members.size()));
  for (std::size_t k = 0; k < members.size(); ++k) {
    const SparseRow& row = rows[members[k]];
    for (std::size_t e = 0; e < row.columns.size(); ++e)
      matrix(place.at(row.columns[e]), static_cast<Eigen::Index>(k)) = row.values[e];
  }
  return matrix;
}

}  // namespace

std::vector<bool> independent_rows(const std::vector<SparseRow>& rows,
                                   int columns,
                                   double tolerance) {
  std::vector<bool> independent(rows.size(), false);
  for (const auto& [root, members] : components(rows, columns)) {
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(dense_columns(rows, members));
    const Eigen::Index most = std::min(qr.rows(), qr.cols());
    for (Eigen::Index k = 0; k < most && std::abs(qr.matrixQR()(k, k)) > tolerance; ++k)
      independent[members[qr.colsPermutation().indices()(k)]] = true;
  }
  return independent;
}

}  // namespace wuerfel
