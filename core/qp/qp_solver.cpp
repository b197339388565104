#include "core/qp/qp_solver.h"

#include "core/qp/block_solver.h"
#include "core/qp/ipopt_solver.h"

namespace wuerfel {

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
  return std::make_unique<BlockSolver>(method, settings);
}

}  // namespace wuerfel
