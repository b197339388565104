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
  enum class Winner { none, newton, interior_point };

  void run(const QuadraticProgram& program, const ResidualScales& scales, QpResult& result);
  bool run_newton(const QuadraticProgram& program,
                  const ResidualScales& scales,
                  int most,
                  QpResult& result);
  bool run_interior_point(const QuadraticProgram& program,
                          const ResidualScales& scales,
                          bool warm,
                          double proximal,
                          QpResult& result);
  [[nodiscard]] double goal() const;
  QpResidual settle(const QuadraticProgram& program,
                    const ResidualScales& scales,
                    const std::vector<double>& multiplier,
                    const QpResidual& before,
                    int& factorisations);
  void weight_tight_rows(const ResidualScales& scales, const std::vector<double>& multiplier);
  bool take(const QuadraticProgram& program,
            const ResidualScales& scales,
            const MethodOutcome& outcome,
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
  Winner winner_ = Winner::none;
  int since_newton_ = 0;  ///< solves since newton was last tried
  std::vector<double> x_, former_x_, weight_, rest_;
  std::vector<Quad> y_, d_;
};

}  // namespace wuerfel
