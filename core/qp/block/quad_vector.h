/// Sums over vectors of blocks. Not for files compiled for one kind of CPU: see block_kernels.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/qp/block/block_kernels.h"

namespace wuerfel {

/// The largest number of a block, without its sign.
inline double largest(const Quad& q) {
  return std::max({std::abs(q.v[0]), std::abs(q.v[1]), std::abs(q.v[2])});
}

inline double dot(const std::vector<Quad>& a, const std::vector<Quad>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i].v[0] * b[i].v[0] + a[i].v[1] * b[i].v[1] + a[i].v[2] * b[i].v[2];
  return sum;
}

/// y := y + factor d
inline void add(double factor, const std::vector<Quad>& d, std::vector<Quad>& y) {
  for (std::size_t b = 0; b < y.size(); ++b) {
    for (int c = 0; c < 3; ++c)
      y[b].v[c] += factor * d[b].v[c];
  }
}

}  // namespace wuerfel
