#include "core/qp/block/block_cholesky.h"

namespace wuerfel {

void BlockCholesky::plan(int blocks,
                         const std::vector<int>& start,
                         const std::vector<int>& neighbour,
                         std::vector<int>& order) {
  pattern_.plan(blocks, start, neighbour, order);
  L_.resize(3 * fill());
  pivot_.resize(blocks);
  inverse_.resize(blocks);
  place_of_.resize(blocks);
}

BlockFactor BlockCholesky::view() {
  return {pattern_.blocks,
          pattern_.column_start.data(),
          pattern_.row.data(),
          pattern_.list_start.data(),
          pattern_.list_column.data(),
          pattern_.list_place.data(),
          L_.data(),
          pivot_.data(),
          inverse_.data(),
          place_of_.data()};
}

void BlockCholesky::factorise(const BlockRows& rows, const double* d) {
  const BlockFactor factor = view();
  kernels_->assemble(rows, d, factor);
  kernels_->factorise(factor);
}

}  // namespace wuerfel
