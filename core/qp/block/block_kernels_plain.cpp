#include <emmintrin.h>

#include "core/qp/block/block_kernels.h"

namespace wuerfel {
namespace {

struct Lane {
  __m128d low, high;
};

inline Lane load(const Quad* q) { return {_mm_load_pd(q->v), _mm_load_pd(q->v + 2)}; }
inline void store(Quad* q, Lane a) {
  _mm_store_pd(q->v, a.low);
  _mm_store_pd(q->v + 2, a.high);
}
inline Lane all(double a) { return {_mm_set1_pd(a), _mm_set1_pd(a)}; }
inline Lane operator+(Lane a, Lane b) {
  return {_mm_add_pd(a.low, b.low), _mm_add_pd(a.high, b.high)};
}
inline Lane operator-(Lane a, Lane b) {
  return {_mm_sub_pd(a.low, b.low), _mm_sub_pd(a.high, b.high)};
}
inline Lane operator*(Lane a, Lane b) {
  return {_mm_mul_pd(a.low, b.low), _mm_mul_pd(a.high, b.high)};
}
inline double sum_of(Lane a) {
  const __m128d s = _mm_add_pd(a.low, a.high);
  return _mm_cvtsd_f64(_mm_add_sd(s, _mm_unpackhi_pd(s, s)));
}

#include "core/qp/block/block_kernels.inc"

constexpr BlockKernels kernels{apply, apply_transposed, assemble, factorise, solve};

}  // namespace

const BlockKernels& plain_block_kernels() { return kernels; }

}  // namespace wuerfel
