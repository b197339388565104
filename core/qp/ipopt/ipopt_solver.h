/// The referee: Ipopt, an independent interior point method that thousands of others have tested
/// [Waechter, Biegler 2006].
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/qp/ipopt/ipopt_module.h"
#include "core/qp/qp_solver.h"

namespace wuerfel {

class IpoptSolver final : public QpSolver {
 public:
  explicit IpoptSolver(const QpSettings& settings) : settings_(settings) {}
  void solve(const QuadraticProgram& program, QpResult& result) override;
  [[nodiscard]] std::string_view name() const override { return "ipopt"; }
  [[nodiscard]] std::string_view trouble() const override { return trouble_; }

 private:
  bool open();
  void solve_checked(const QuadraticProgram& program, QpResult& result);

  QpSettings settings_;
  std::unique_ptr<IpoptSession> session_;
  std::string trouble_;
};

}  // namespace wuerfel
