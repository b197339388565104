#include "core/qp/qp_solver.h"

#include "core/qp/automatic.h"
#include "core/qp/ipopt/ipopt_solver.h"
#include "core/qp/methods/block_methods.h"

namespace wuerfel {
namespace {

/// Newton or interior point alone: there is no other method, so newton is patient.
class SingleMethod final : public QpSolver {
 public:
  SingleMethod(QpMethod method, const QpSettings& settings) : method_(method), methods_(settings) {}
  void solve(const QuadraticProgram& program, QpResult& result) override {
    if (!methods_.begin(program, result)) {
      if (result.status == QpStatus::invalid) forget();
      return;
    }
    if (method_ == QpMethod::newton) {
      methods_.run_newton(program, {.most_factorisations = 400, .patience = 30}, result);
    } else {
      methods_.run_interior_point(program, result);
    }
    methods_.end(result);
  }
  [[nodiscard]] std::string_view name() const override { return to_string(method_); }
  [[nodiscard]] std::string_view trouble() const override { return methods_.trouble(); }
  void forget() override { methods_.forget(); }

 private:
  QpMethod method_;
  BlockMethods methods_;
};

}  // namespace

std::string_view to_string(QpStatus status) {
  switch (status) {
    case QpStatus::optimal:
      return "optimal";
    case QpStatus::inaccurate:
      return "inaccurate";
    case QpStatus::infeasible:
      return "infeasible";
    case QpStatus::invalid:
      return "invalid";
    case QpStatus::unavailable:
      return "unavailable";
  }
  return "?";
}

std::string_view to_string(QpMethod method) {
  switch (method) {
    case QpMethod::automatic:
      return "auto";
    case QpMethod::newton:
      return "newton";
    case QpMethod::interior_point:
      return "interior-point";
    case QpMethod::ipopt:
      return "ipopt";
  }
  return "?";
}

std::unique_ptr<QpSolver> make_qp_solver(QpMethod method, const QpSettings& settings) {
  if (method == QpMethod::ipopt) return std::make_unique<IpoptSolver>(settings);
  if (method == QpMethod::automatic) return std::make_unique<AutomaticSolver>(settings);
  return std::make_unique<SingleMethod>(method, settings);
}

}  // namespace wuerfel
