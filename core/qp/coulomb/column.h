/// A column of a 3x3 block in a register, or in two: for loops that are cloned (clones.h). Sums are made
/// in it, and not in memory, where they might be other numbers of the same loop.
#pragma once

#include <cstring>

#include "core/qp/block/block_kernels.h"

namespace wuerfel {

using Column = double __attribute__((vector_size(sizeof(Quad))));

inline void load(const Quad& q, Column& column) { std::memcpy(&column, &q, sizeof q); }
inline void store(const Column& column, Quad& q) { std::memcpy(&q, &column, sizeof q); }

}  // namespace wuerfel
