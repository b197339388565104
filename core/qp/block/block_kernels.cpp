#include "core/qp/block/block_kernels.h"

namespace wuerfel {

const BlockKernels& best_block_kernels() {
  return __builtin_cpu_supports("avx2") != 0 ? avx2_block_kernels() : plain_block_kernels();
}

}  // namespace wuerfel
