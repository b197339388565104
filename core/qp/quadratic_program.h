/// The one problem type of the house. Gauss' principle (9), Moreau's impact law and the length
/// correction are all
///
///     minimise  1/2 (x - f)' M (x - f)    subject to    J_e x = b_e,   J_s x >= b_s
///
/// with diagonal M > 0. Its multipliers are the forces:  M (x - f) = J' lambda.
///
/// A row is a restriction together with the range of its multiplier, [force_min, force_max]:
///
///     equality (rod)              (-inf, inf)   J x  = b
///     inequality (side)           [0, inf)      J x >= b,  lambda >= 0,  lambda (J x - b) = 0
///     bounded (Coulomb friction)  [-r, r]       J x  = b  where |lambda| < r,
///                                               J x <= b  where lambda = r,
///                                               J x >= b  where lambda = -r
///
/// so that friction needs no second problem type. Nothing here knows of cubes.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace wuerfel {

inline constexpr double unbounded = std::numeric_limits<double>::infinity();

struct QuadraticProgram {
  /// Unknowns come in blocks (3 of a rigid cube, 2 of a point); rows couple few blocks, and solvers
  /// work on the graph of blocks.
  int block_size = 3;
  std::vector<double> mass;    ///< diagonal of M, > 0; size n = blocks * block_size
  std::vector<double> target;  ///< f; size n

  // Rows, compressed: entries of row i are row_start[i] .. row_start[i+1]-1. Within a row every
  // block occurs once.
  std::vector<double> bound;         ///< b; size m
  std::vector<double> force_min;     ///< smallest multiplier; size m, -inf or <= 0
  std::vector<double> force_max;     ///< largest multiplier; size m, +inf or >= 0
  std::vector<int> row_start{0};     ///< size m + 1
  std::vector<int> entry_block;      ///< size row_start[m]
  std::vector<double> coefficients;  ///< size row_start[m] * block_size

  /// Empty, or one per row: the same number for the same restriction in one program after another,
  /// for solvers that remember.
  std::vector<std::int64_t> row_name;

  [[nodiscard]] int unknowns() const { return static_cast<int>(mass.size()); }
  [[nodiscard]] int blocks() const { return block_size > 0 ? unknowns() / block_size : 0; }
  [[nodiscard]] int rows() const { return static_cast<int>(bound.size()); }
  [[nodiscard]] int entries() const { return row_start.back(); }
  [[nodiscard]] bool is_equality(int row) const {
    return force_min[row] == -unbounded && force_max[row] == unbounded;
  }
  [[nodiscard]] std::span<const int> blocks_of(int row) const {
    return {entry_block.data() + row_start[row], entry_block.data() + row_start[row + 1]};
  }
  [[nodiscard]] std::span<const double> entry(int e) const {
    return std::span<const double>(coefficients.data() + e * block_size, block_size);
  }

  /// An unknown times this is alike the first one of its block: an angle becomes a length.
  [[nodiscard]] double unit(int unknown) const {
    return std::sqrt(mass[unknown] / mass[unknown - unknown % block_size]);
  }

  /// start + J x of a row; `x` of size n.
  [[nodiscard]] double row_value(int row, const std::vector<double>& x, double start = 0.0) const {
    const double* y = x.data();
    for_each_entry(row, [&start, y](const double* J, int first, int size) {
      for (int c = 0; c < size; ++c)
        start += J[c] * y[first + c];
    });
    return start;
  }
  /// J x - b of a row.
  [[nodiscard]] double slack(int row, const std::vector<double>& x) const {
    return row_value(row, x, -bound[row]);
  }
  /// Whether x = 0 satisfies all rows, so that there is a solution, however far away it is.
  [[nodiscard]] bool allows_rest() const {
    for (int i = 0; i < rows(); ++i) {
      if (bound[i] > 0.0 && force_max[i] == unbounded) return false;
      if (bound[i] < 0.0 && force_min[i] == -unbounded) return false;
    }
    return true;
  }
  /// forces += J' multiplier of a row; `forces` is a vector of size n.
  template <typename Forces>
  void add_row_force(int row, double multiplier, Forces&& forces) const {
    for_each_entry(row, [&](const double* J, int first, int size) {
      for (int c = 0; c < size; ++c)
        forces[first + c] += J[c] * multiplier;
    });
  }
  /// Calls visit(coefficients, first unknown, block_size) for every entry of a row.
  template <typename Visit>
  void for_each_entry(int row, const Visit& visit) const {
    constexpr int usual_size = 3;  // known to the compiler it is faster
    const int* block = entry_block.data() + row_start[row];
    const int* const end = entry_block.data() + row_start[row + 1];
    const double* J = coefficients.data() + row_start[row] * block_size;
    if (block_size == usual_size) {
      for (; block != end; ++block, J += usual_size)
        visit(J, *block * usual_size, usual_size);
    } else {
      for (; block != end; ++block, J += block_size)
        visit(J, *block * block_size, block_size);
    }
  }

  /// Forgets the program and keeps the memory.
  void clear(int new_block_size) {
    block_size = new_block_size;
    for (auto* v : {&mass, &target, &bound, &force_min, &force_max, &coefficients})
      v->clear();
    row_start.assign(1, 0);
    entry_block.clear();
    row_name.clear();
  }
  /// Adds the block of `block_size` masses and targets; returns its number.
  int add_block(std::span<const double> masses, std::span<const double> targets) {
    mass.insert(mass.end(), masses.begin(), masses.end());
    target.insert(target.end(), targets.begin(), targets.end());
    return blocks() - 1;
  }
  /// Starts a row; its entries follow by add_entry. Returns its number.
  int add_row(double b, double min_force, double max_force) {
    bound.push_back(b);
    force_min.push_back(min_force);
    force_max.push_back(max_force);
    row_start.push_back(row_start.back());
    return rows() - 1;
  }
  int add_equality(double b) { return add_row(b, -unbounded, unbounded); }
  int add_inequality(double b) { return add_row(b, 0.0, unbounded); }
  /// Adds `block_size` coefficients on one block to the last row.
  void add_entry(int block, std::span<const double> values) {
    entry_block.push_back(block);
    coefficients.insert(coefficients.end(), values.begin(), values.end());
    ++row_start.back();
  }
};

}  // namespace wuerfel
