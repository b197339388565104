/// The multipliers to show, for programs of any size: of all optimal ones those of least sum of
/// squares, and which of them are the only ones possible. Sparse; LeastNormMultipliers (dense,
/// exact) is the oracle.
///
/// Values: proximal iteration u := u + y - G' lambda(y + u), where lambda(t) minimises 1/2
/// |lambda|^2 with G' lambda = t up to 1/rho by semismooth Newton steps; its limit is the least
/// norm whatever rows come and go. Flags: a row has one possible multiplier if it is zero in all of
/// them (an interior point finds multipliers that are as positive as possible), or has no part in
/// any vector v with G' v = 0 on the others. The latter is seen from projections of two random
/// vectors onto that space.
#pragma once

#include <vector>

#include "core/qp/block_kernels.h"
#include "core/qp/interior_point_method.h"
#include "core/qp/least_distance.h"
#include "core/qp/least_norm_multipliers.h"
#include "core/qp/newton_method.h"
#include "core/qp/optimality_meter.h"

namespace wuerfel {

class CanonicalMultipliers {
 public:
  explicit CanonicalMultipliers(const BlockKernels& kernels = best_block_kernels());

  /// From a solution, x and multipliers, of residual about 1e-10 or better. Rows of the program
  /// count with their own length: write them with unit normals. `misfit` above about 1e-8 means
  /// that no better multipliers than the given ones were found, and they are returned.
  /// `with_unique` false leaves the flags false and saves half of the time.
  void find(const QuadraticProgram& program,
            const std::vector<double>& x,
            const std::vector<double>& multiplier,
            bool with_unique,
            LeastNormMultipliers& result);

 private:
  void select(const QuadraticProgram& program,
              const std::vector<double>& x,
              const std::vector<double>& multiplier);
  void keep_rows(const QuadraticProgram& program, const std::vector<bool>& kept);
  bool find_values(double& misfit);
  void find_flags(const QuadraticProgram& program, LeastNormMultipliers& result);
  bool find_support(const QuadraticProgram& program);
  double project();
  bool mark_dependent(std::vector<bool>& dependent);

  LeastDistance tight_, whole_;
  NewtonMethod newton_;
  InteriorPointMethod interior_point_;
  OptimalityMeter meter_;
  QuadraticProgram program_;        ///< the tight rows alone
  std::vector<int> row_;            ///< of the whole program, per tight row
  std::vector<double> multiplier_;  ///< per tight row
  std::vector<bool> kept_;
  std::vector<Quad> y_, shift_, d_;
  std::vector<double> weight_, v_, part_;
};

}  // namespace wuerfel
