/// The program when it is known which rows are tight: minimise 1/2 (x - f)' M (x - f) under J x =
/// b. No search, one factorisation: the right-hand side of smooth motion between events.
#pragma once

#include <cstddef>
#include <vector>

#include "core/qp/quadratic_program.h"

namespace wuerfel {

/// A pivot below this share of its diagonal, or of the largest, belongs to a row that depends on others.
inline constexpr double dependent_share = 1e-11;

/// Solves J M^-1 J' lambda = b - J f by a Cholesky factorisation within the envelope of the matrix
/// [George, Liu 1981]. A row
/// that depends on the rows before it is left out: its multiplier stays, and it holds by itself
/// where the rows are consistent. Keeps its memory and, while the same rows couple the same blocks,
/// the envelope.
class EqualitySolver {
 public:
  /// Rows marked in `tight` (size m; none: all) are taken as equalities, whatever range their
  /// multipliers have; the others are left out. The coefficients must be numbers and the masses
  /// positive.
  void factorise(const QuadraticProgram& program, const std::vector<char>* tight = nullptr);

  /// The same rows with other numbers.
  void factorise_again(const QuadraticProgram& program);

  /// `x` (n) and `multiplier` (m, zero on rows that are not tight) for the bounds and targets of
  /// `program`, whose coefficients are those of the last `factorise`. Refined until J x = b to
  /// rounding.
  void solve(const QuadraticProgram& program,
             std::vector<double>& x,
             std::vector<double>& multiplier);
  /// The same from multipliers that are nearly right. Body by body x is as exact as its own forces
  /// are, and where rows depend on others the multipliers stay near those given.
  void refine(const QuadraticProgram& program,
              std::vector<double>& x,
              std::vector<double>& multiplier);

  /// Number of rows that were left out because they depend on others.
  [[nodiscard]] int dependent_rows() const { return dependent_; }

 private:
  /// Two entries on one block, and where their product goes in the factor.
  struct Coupling {
    std::ptrdiff_t place = 0;
    int block = 0;
    int entry_i = 0;
    int entry_j = 0;
  };
  /// An entry on a block, of the row at place i of the order.
  struct Entry {
    int i = 0;
    int entry = 0;
  };
  [[nodiscard]] bool fits(const QuadraticProgram& program, const std::vector<char>* tight) const;
  void add_couplings(int i, int j);
  void fill_triangle();
  void find_envelope();
  void assemble(const QuadraticProgram& program);
  struct Missed {
    double worst = 0.0;  ///< of the rows that are kept
    double scale = 0.0;  ///< the largest bound or J x
  };
  Missed find_residual(const QuadraticProgram& program, const std::vector<double>& x);
  void move_onto_rows(const QuadraticProgram& program,
                      std::vector<double>& x,
                      std::vector<double>& multiplier);
  void substitute(std::vector<double>& r) const;
  [[nodiscard]] std::ptrdiff_t place(int i, int j) const { return start_[i] + j; }
  [[nodiscard]] double at(int i, int j) const { return factor_[place(i, j)]; }

  std::vector<int> row_start_;  ///< of the program that the envelope belongs to
  std::vector<int> entry_block_;
  std::vector<char> tight_;
  std::vector<int> row_;                         ///< tight rows of the program
  std::vector<int> order_;                       ///< these rows in the order of elimination
  std::vector<std::vector<int>> rows_of_block_;  ///< by number in row_
  std::vector<std::vector<Entry>> entries_of_block_;
  std::vector<Coupling> couplings_;
  std::vector<int> first_;             ///< first column within the envelope of the row at place i
  std::vector<std::ptrdiff_t> start_;  ///< where column 0 of that row is, or would be, in factor_
  std::vector<double> factor_;
  std::vector<double> inverse_;  ///< 1 / diagonal; 0 for a row that is left out
  std::vector<double> residual_;
  int dependent_ = 0;
};

}  // namespace wuerfel
