/// A QuadraticProgram as the fast solvers see it: a least distance problem on blocks of three
/// unknowns.
///
///     minimise 1/2 |y|^2   subject to   G y (=, >=) h,     y = M^(1/2) (x - f),  G = J M^(-1/2),
///     h = b - J f
///
/// Multipliers are those of the program. Every matrix to be factorised is K = I + G' D G, positive
/// definite whatever rows are redundant. Blocks of another size than three are padded or cut into
/// threes; they are numbered in the order of elimination.
#pragma once

#include <cstddef>
#include <vector>

#include "core/qp/block/block_cholesky.h"
#include "core/qp/block/block_kernels.h"
#include "core/qp/quadratic_program.h"

namespace wuerfel {

class LeastDistance {
 public:
  explicit LeastDistance(const BlockKernels& kernels) : kernels_(&kernels), cholesky_(kernels) {}

  /// Takes over a sound program (see `defect`). Order and symbolic factors stay if the couplings
  /// fit into the last ones.
  void prepare(const QuadraticProgram& program);
  void forget();

  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int blocks() const { return blocks_; }
  /// Whether the rows couple the same blocks, row by row, as those of the program before.
  [[nodiscard]] bool same_rows() const { return same_rows_; }
  /// For each row the one of the program before with the same blocks, or -1. Only if !same_rows().
  [[nodiscard]] const std::vector<int>& former_row() const { return former_row_; }
  [[nodiscard]] int fill() const { return cholesky_.fill(); }
  [[nodiscard]] const BlockRows& view() const { return view_; }

  // One value per row.
  [[nodiscard]] const std::vector<double>& h() const { return h_; }
  [[nodiscard]] const std::vector<double>& force_min() const { return force_min_; }
  [[nodiscard]] const std::vector<double>& force_max() const { return force_max_; }
  [[nodiscard]] const std::vector<double>& square() const { return square_; }  ///< |g|^2

  void apply(const Quad* y, double* out) const { kernels_->apply(view_, y, out); }
  void apply_transposed(const double* factor, Quad* out) const {
    kernels_->apply_transposed(view_, factor, out);
  }
  /// K = I + G' diag(d) G, d >= 0
  void factorise(const double* d) { cholesky_.factorise(view_, d); }
  void solve(Quad* v) { cholesky_.solve(v); }

  /// The largest force M^(1/2) u of an unbalance u = y - G' lambda, as QpResidual measures it.
  [[nodiscard]] double force_of(const std::vector<Quad>& unbalance) const;
  /// M^(-1/2) force, from the numbering of the program.
  void pack(const std::vector<double>& force, std::vector<Quad>& y) const;
  /// x = f + M^(-1/2) y, in the numbering of the program.
  void read(const QuadraticProgram& program,
            const std::vector<Quad>& y,
            std::vector<double>& x) const;

 private:
  [[nodiscard]] bool has_same_rows(const QuadraticProgram& program) const;
  void match_rows(const QuadraticProgram& program);
  void number_entries();
  bool place_pairs();
  void plan();
  void find_graph();
  void scale(const QuadraticProgram& program);
  void scale_masses(const QuadraticProgram& program);
  void scale_threes(const QuadraticProgram& program);
  void scale_row(const QuadraticProgram& program, int row);

  const BlockKernels* kernels_;
  BlockCholesky cholesky_;
  BlockRows view_;
  int rows_ = 0;
  int blocks_ = 0;
  int block_size_ = 0;
  int parts_ = 1;  ///< threes per block of the program
  bool same_rows_ = false;
  bool planned_ = false;
  std::size_t planned_pairs_ = 0;  ///< couplings at the time of the plan

  std::vector<int> row_start_, entry_block_;  ///< of the program
  std::vector<int> former_row_, former_start_,
      former_block_;                       ///< of the one before, to see what changed
  std::vector<int> order_, position_;      ///< elimination: number -> block, block -> number
  std::vector<int> start_, block_, pair_;  ///< rows in elimination numbers, as BlockRows wants them
  std::vector<int> source_;                ///< per entry: entry of the program * parts + part
  std::vector<int> graph_start_, graph_;
  std::vector<Quad> g_, root_;  ///< root: M^(-1/2) by elimination number
  std::vector<double> mass_, h_, square_, force_min_, force_max_;
};

}  // namespace wuerfel
