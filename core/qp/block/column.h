/// A column of a 3x3 block in a register, or in two: for loops that are cloned (clones.h). Sums are made
/// in it, and not in memory, where they might be other numbers of the same loop.
#pragma once

#include <cstring>

#include "core/qp/block/block_kernels.h"

namespace wuerfel {

using Column = double __attribute__((vector_size(sizeof(Quad))));

/// From and to four numbers that follow one another.
inline void load(const double* from, Column& column) { std::memcpy(&column, from, sizeof column); }
inline void store(const Column& column, double* to) { std::memcpy(to, &column, sizeof column); }
inline void load(const Quad& q, Column& column) { load(q.v, column); }
inline void store(const Column& column, Quad& q) { store(column, q.v); }

}  // namespace wuerfel
