// Compiled for AVX2, so nothing is included that could leave a shared inline function behind.
#include <immintrin.h>

#include "core/qp/block/block_kernels.h"

namespace wuerfel {
namespace {

struct Lane {
  __m256d v;
};

inline Lane load(const Quad* q) { return {_mm256_load_pd(q->v)}; }
inline void store(Quad* q, Lane a) { _mm256_store_pd(q->v, a.v); }
inline Lane all(double a) { return {_mm256_set1_pd(a)}; }
inline Lane operator+(Lane a, Lane b) { return {_mm256_add_pd(a.v, b.v)}; }
inline Lane operator-(Lane a, Lane b) { return {_mm256_sub_pd(a.v, b.v)}; }
inline Lane operator*(Lane a, Lane b) { return {_mm256_mul_pd(a.v, b.v)}; }
inline double sum_of(Lane a) {
  const __m128d s = _mm_add_pd(_mm256_castpd256_pd128(a.v), _mm256_extractf128_pd(a.v, 1));
  return _mm_cvtsd_f64(_mm_add_sd(s, _mm_unpackhi_pd(s, s)));
}

#include "core/qp/block/block_kernels.inc"

constexpr BlockKernels kernels{apply, apply_transposed, assemble, factorise, solve};

}  // namespace

const BlockKernels& avx2_block_kernels() { return kernels; }

}  // namespace wuerfel
