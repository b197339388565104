/// The multipliers to show, for programs of any size: of all optimal ones those of least sum of
/// squares, and which of them are the only ones possible.
///
/// Values: LeastNormMethod on the rows that may carry force. Flags: a row has one possible multiplier
/// if it is at the same bound in all of them, or has no part in any vector v with G' v = 0 on the
/// others. The latter is seen from projections of two arbitrary vectors onto that space.
#pragma once

#include <vector>

#include "core/qp/block/block_kernels.h"
#include "core/qp/block/least_distance.h"
#include "core/qp/methods/least_norm_method.h"
#include "core/qp/residual_meter.h"

namespace wuerfel {

struct LeastNormMultipliers {
  std::vector<double> multiplier;  ///< m
  std::vector<bool> unique;        ///< m: whether no other optimal multiplier of this row exists
  double misfit = 0.0;             ///< ResidualMeter::imbalance of these very multipliers
};

class CanonicalMultipliers {
 public:
  explicit CanonicalMultipliers(const BlockKernels& kernels = best_block_kernels());

  /// From a solution, x and multipliers. Rows of the program count with their own length: write them
  /// with unit normals. Where the least norm cannot be found as exactly as the multipliers given
  /// balance x, these are returned. `with_unique` false leaves the flags false and saves half of the
  /// time.
  void find(const QuadraticProgram& program,
            const std::vector<double>& x,
            const std::vector<double>& multiplier,
            bool with_unique,
            LeastNormMultipliers& result);

 private:
  void keep_tight_rows(const QuadraticProgram& program,
                       const std::vector<double>& x,
                       std::vector<double>& multiplier);
  void balance_rows(const QuadraticProgram& program,
                    const std::vector<double>& x,
                    const std::vector<double>& multiplier);
  void find_flags(LeastNormMultipliers& result);
  bool find_support();
  double project();
  bool mark_dependent(std::vector<char>& dependent);

  LeastDistance tight_;
  LeastNormMethod least_norm_;
  ResidualMeter meter_;
  /// The tight rows alone, with masses of one kilogram: the multipliers must balance J' lambda,
  /// whatever the masses are, and without their ratios the rows are much more alike. Its solution is
  /// the point where these rows are tight and the forces in balance.
  QuadraticProgram program_;
  std::vector<int> row_;       ///< of the whole program, per tight row
  std::vector<double> force_;  ///< that the tight rows have to balance
  std::vector<Quad> target_, d_;
  std::vector<double> weight_, scale_, v_, part_;
};

}  // namespace wuerfel
