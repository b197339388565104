/// Our own solver: one scaled problem and one factorisation, two methods to use them.
#pragma once

#include <string_view>

#include "core/qp/interior_point_method.h"
#include "core/qp/least_distance.h"
#include "core/qp/newton_method.h"
#include "core/qp/optimality_meter.h"
#include "core/qp/qp_solver.h"

namespace wuerfel {

class BlockSolver final : public QpSolver {
 public:
  /// `method` is one of automatic, newton, interior_point.
  BlockSolver(QpMethod method,
              const QpSettings& settings,
              const BlockKernels& kernels = best_block_kernels());
  void solve(const QuadraticProgram& program, QpResult& result) override;
  [[nodiscard]] std::string_view name() const override { return to_string(method_); }
  [[nodiscard]] std::string_view trouble() const override { return trouble_; }
  void forget() override;

 private:
  [[nodiscard]] bool has_impossible_row(const ResidualScales& scales) const;
  void run(const QuadraticProgram& program, const ResidualScales& scales, QpResult& result);
  bool newton_is_due();
  bool run_newton(const QuadraticProgram& program,
                  const ResidualScales& scales,
                  const NewtonEffort& effort,
                  QpResult& result);
  void run_interior_point(const QuadraticProgram& program,
                          const ResidualScales& scales,
                          QpResult& result);
  [[nodiscard]] double goal() const;
  QpResidual settle(const QuadraticProgram& program,
                    const ResidualScales& scales,
                    std::vector<double>& multiplier,
                    const QpResidual& before,
                    int& factorisations);
  void weight_tight_rows(const ResidualScales& scales, const std::vector<double>& multiplier);
  bool take(const QuadraticProgram& program,
            const ResidualScales& scales,
            const MethodOutcome& outcome,
            double enough,
            const std::vector<Quad>& y,
            const std::vector<double>& multiplier,
            QpResult& result);

  QpMethod method_;
  QpSettings settings_;
  LeastDistance problem_;
  NewtonMethod newton_;
  InteriorPointMethod interior_point_;
  OptimalityMeter meter_;
  std::string_view trouble_;
  // What automatic remembers.
  bool newton_won_ = false;         ///< the last time
  bool knows_sides_ = false;        ///< newton starts from those of a solution
  bool tried_newton_ = false;       ///< from a guess
  bool tried_known_sides_ = false;  ///< from those of interior_point
  int since_newton_ = 0;            ///< solves since it was last tried
  // Of the interior point runs last made.
  int warm_factorisations_ = 0;
  int cold_factorisations_ = 0;
  std::vector<double> x_, former_x_, multiplier_, moved_, weight_, rest_, change_;
  std::vector<Quad> y_, d_, unbalance_;
};

}  // namespace wuerfel
