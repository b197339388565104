#include "core/qp/block/elimination_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace wuerfel {
namespace {

constexpr int most_in_a_word = 64;

/// Neighbours as bits of a word.
void order_few(int blocks,
               const std::vector<int>& start,
               const std::vector<int>& neighbour,
               std::vector<int>& order) {
  std::array<std::uint64_t, most_in_a_word> near{};
  std::uint64_t left = 0;
  for (int b = 0; b < blocks; ++b) {
    left |= std::uint64_t{1} << b;
    for (int e = start[b]; e < start[b + 1]; ++e)
      near[b] |= std::uint64_t{1} << neighbour[e];
  }
  while (left != 0) {
    int best = std::countr_zero(left);
    int least = blocks + 1;
    for (std::uint64_t rest = left; rest != 0; rest &= rest - 1) {
      const int b = std::countr_zero(rest);
      const int degree = std::popcount(near[b] & left);
      if (degree < least) {
        least = degree;
        best = b;
      }
    }
    left &= ~(std::uint64_t{1} << best);
    const std::uint64_t clique = near[best] & left;
    for (std::uint64_t rest = clique; rest != 0; rest &= rest - 1) {
      const int b = std::countr_zero(rest);
      near[b] |= clique & ~(std::uint64_t{1} << b);
    }
    order.push_back(best);
  }
}

void order_many(int blocks,
                const std::vector<int>& start,
                const std::vector<int>& neighbour,
                std::vector<int>& order) {
  // Eigen orders blocks without a diagonal entry first, whatever their neighbours.
  Eigen::SparseMatrix<double, Eigen::ColMajor, int> pattern(blocks, blocks);
  pattern.resizeNonZeros(static_cast<Eigen::Index>(neighbour.size()) + blocks);
  int* to = pattern.innerIndexPtr();
  for (int b = 0; b < blocks; ++b) {
    pattern.outerIndexPtr()[b] = static_cast<int>(to - pattern.innerIndexPtr());
    const auto first = neighbour.begin() + start[b];
    const auto last = neighbour.begin() + start[b + 1];
    const auto middle = std::lower_bound(first, last, b);
    to = std::copy(first, middle, to);
    *to++ = b;
    to = std::copy(middle, last, to);
  }
  pattern.outerIndexPtr()[blocks] = static_cast<int>(to - pattern.innerIndexPtr());
  std::fill_n(pattern.valuePtr(), pattern.nonZeros(), 1.0);
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation(blocks);
  Eigen::AMDOrdering<int>()(pattern, permutation);
  order.assign(permutation.indices().data(), permutation.indices().data() + blocks);
}

}  // namespace

void elimination_order(int blocks,
                       const std::vector<int>& start,
                       const std::vector<int>& neighbour,
                       std::vector<int>& order) {
  order.clear();
  if (blocks <= most_in_a_word) {
    order_few(blocks, start, neighbour, order);
  } else {
    order_many(blocks, start, neighbour, order);
  }
}

}  // namespace wuerfel
