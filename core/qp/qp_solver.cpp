#include "core/qp/qp_solver.h"

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
    case QpMethod::ipopt:
      return "ipopt";
  }
  return "?";
}

std::unique_ptr<QpSolver> make_qp_solver(QpMethod method, const QpSettings& settings) {
  switch (method) {
    case QpMethod::ipopt:
      return std::make_unique<IpoptSolver>(settings);
  }
  return nullptr;
}

}  // namespace wuerfel
