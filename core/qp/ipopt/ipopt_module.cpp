#include "core/qp/ipopt/ipopt_module.h"

#include <IpIpoptApplication.hpp>
#include <IpSolveStatistics.hpp>
#include <IpTNLP.hpp>
#include <algorithm>
#include <cstddef>
#include <memory>
#include <mutex>

namespace wuerfel {
namespace {

using Ipopt::Index;
using Ipopt::Number;

// NOLINTBEGIN(readability-function-size): the parameters are Ipopt's.
/// The convex program with exact, constant derivatives.
class ElasticProgram final : public Ipopt::TNLP {
 public:
  ElasticProgram(const IpoptProgram& program, IpoptPoint& point)
      : program_(program), point_(point) {}

  [[nodiscard]] bool has_point() const { return has_point_; }

  bool get_nlp_info(
      Index& n, Index& m, Index& nnz_jac_g, Index& nnz_h_lag, IndexStyleEnum& style) override {
    n = program_.unknowns + program_.elastics;
    m = program_.rows;
    nnz_jac_g = program_.entries;
    nnz_h_lag = program_.unknowns;
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(
      Index n, Number* x_l, Number* x_u, Index m, Number* g_l, Number* g_u) override {
    std::fill(x_l, x_l + program_.unknowns, -1e20);
    std::fill(x_l + program_.unknowns, x_l + n, 0.0);
    std::fill(x_u, x_u + n, 1e20);
    std::copy(program_.lower, program_.lower + m, g_l);
    std::copy(program_.upper, program_.upper + m, g_u);
    return true;
  }

  bool get_starting_point(Index n,
                          bool init_x,
                          Number* x,
                          bool init_z,
                          Number* /*z_L*/,
                          Number* /*z_U*/,
                          Index /*m*/,
                          bool init_lambda,
                          Number* /*lambda*/) override {
    if (init_x) std::fill(x, x + n, 0.0);
    return !init_z && !init_lambda;
  }

  bool eval_f(Index n, const Number* x, bool /*new_x*/, Number& value) override {
    value = 0.0;
    for (Index j = 0; j < program_.unknowns; ++j)
      value += 0.5 * x[j] * x[j];
    for (Index j = program_.unknowns; j < n; ++j)
      value += program_.cost[j - program_.unknowns] * x[j];
    return true;
  }

  bool eval_grad_f(Index n, const Number* x, bool /*new_x*/, Number* gradient) override {
    std::copy(x, x + program_.unknowns, gradient);
    std::copy(program_.cost, program_.cost + (n - program_.unknowns), gradient + program_.unknowns);
    return true;
  }

  bool eval_g(Index /*n*/, const Number* x, bool /*new_x*/, Index m, Number* g) override {
    std::fill(g, g + m, 0.0);
    for (Index e = 0; e < program_.entries; ++e)
      g[program_.row[e]] += program_.value[e] * x[program_.column[e]];
    return true;
  }

  bool eval_jac_g(Index /*n*/,
                  const Number* /*x*/,
                  bool /*new_x*/,
                  Index /*m*/,
                  Index entries,
                  Index* rows,
                  Index* columns,
                  Number* values) override {
    if (values == nullptr) {
      std::copy(program_.row, program_.row + entries, rows);
      std::copy(program_.column, program_.column + entries, columns);
    } else {
      std::copy(program_.value, program_.value + entries, values);
    }
    return true;
  }

  bool eval_h(Index /*n*/,
              const Number* /*x*/,
              bool /*new_x*/,
              Number factor,
              Index /*m*/,
              const Number* /*lambda*/,
              bool /*new_lambda*/,
              Index entries,
              Index* rows,
              Index* columns,
              Number* values) override {
    for (Index j = 0; j < entries; ++j) {
      if (values == nullptr) {
        rows[j] = j;
        columns[j] = j;
      } else {
        values[j] = factor;
      }
    }
    return true;
  }

  /// Ipopt's own tests never pass at these tolerances; this one does once steps are lost in
  /// rounding.
  bool intermediate_callback(Ipopt::AlgorithmMode mode,
                             Index /*iteration*/,
                             Number /*value*/,
                             Number inf_pr,
                             Number /*inf_du*/,
                             Number mu,
                             Number d_norm,
                             Number /*regularization*/,
                             Number /*alpha_du*/,
                             Number /*alpha_pr*/,
                             Index /*trials*/,
                             const Ipopt::IpoptData* /*data*/,
                             Ipopt::IpoptCalculatedQuantities* /*cq*/) override {
    if (mode != Ipopt::RegularMode || mu > 1e-18 || inf_pr > 1e-14) return true;
    const bool settled = d_norm < 1e-12 && mu < 1e-21;
    if (d_norm < 1e-9) ++lost_steps_;
    return !settled && lost_steps_ < 12;
  }

  void finalize_solution(Ipopt::SolverReturn status,
                         Index n,
                         const Number* x,
                         const Number* /*z_L*/,
                         const Number* /*z_U*/,
                         Index m,
                         const Number* /*g*/,
                         const Number* lambda,
                         Number /*value*/,
                         const Ipopt::IpoptData* /*data*/,
                         Ipopt::IpoptCalculatedQuantities* /*cq*/) override {
    std::copy(x, x + n, point_.y);
    // Ipopt's Lagrangian is f + lambda' g.
    std::transform(lambda, lambda + m, point_.multiplier, [](double l) { return -l; });
    point_.infeasible = status == Ipopt::LOCAL_INFEASIBILITY;
    has_point_ = true;
  }

 private:
  const IpoptProgram& program_;
  IpoptPoint& point_;
  bool has_point_ = false;
  int lost_steps_ = 0;
};

// NOLINTEND(readability-function-size)

/// Set for a referee: driven as far as rounding goes, since Ipopt measures complementarity as a
/// product.
void set_referee_options(Ipopt::OptionsList& options) {
  options.SetIntegerValue("print_level", 0);
  options.SetStringValue("sb", "yes");
  options.SetStringValue("hessian_constant", "yes");
  options.SetStringValue("jac_c_constant", "yes");
  options.SetStringValue("jac_d_constant", "yes");
  options.SetStringValue("nlp_scaling_method", "none");
  options.SetStringValue("linear_solver", "mumps");
  options.SetNumericValue("bound_relax_factor", 0.0);
  options.SetNumericValue("tol", 1e-22);
  options.SetNumericValue("compl_inf_tol", 1e-22);
  options.SetNumericValue("acceptable_tol", 1e-22);
  options.SetNumericValue("constr_viol_tol", 1e-12);
  options.SetNumericValue("dual_inf_tol", 1e-12);
  // Slacks start at the size of the scaled program: started nearer to their bounds, degenerate
  // programs were taken for infeasible.
  options.SetNumericValue("bound_push", 1.0);
  options.SetNumericValue("slack_bound_push", 1.0);
  options.SetIntegerValue("max_iter", 200);
}

/// Where the barrier starts: Ipopt's default, and farther away.
constexpr double usual_start = 0.1;
constexpr double far_start = 1e3;

/// Held while anything of Ipopt works: MUMPS keeps things of its own between calls, for all threads
/// together.
std::mutex& one_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

class Session final : public IpoptSession {
 public:
  Session() = default;
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session() override {
    const std::lock_guard lock(one_at_a_time());
    application_ = nullptr;
  }

  bool start() {
    const std::lock_guard lock(one_at_a_time());
    application_ = IpoptApplicationFactory();
    set_referee_options(*application_->Options());
    return application_->Initialize("") == Ipopt::Solve_Succeeded;
  }

  bool solve(const IpoptProgram& program, IpoptBarrier barrier, IpoptPoint& point) override {
    const std::lock_guard lock(one_at_a_time());
    const bool adaptive = barrier == IpoptBarrier::adaptive;
    application_->Options()->SetStringValue("mu_strategy", adaptive ? "adaptive" : "monotone");
    application_->Options()->SetNumericValue(
        "mu_init", barrier == IpoptBarrier::far ? far_start : usual_start);
    Ipopt::SmartPtr<ElasticProgram> problem = new ElasticProgram(program, point);
    application_->OptimizeTNLP(Ipopt::SmartPtr<Ipopt::TNLP>(GetRawPtr(problem)));
    if (IsValid(application_->Statistics()))
      point.iterations = application_->Statistics()->IterationCount();
    return problem->has_point();
  }

 private:
  Ipopt::SmartPtr<Ipopt::IpoptApplication> application_;
};

}  // namespace
}  // namespace wuerfel

extern "C" __attribute__((visibility("default"))) wuerfel::IpoptSession* wuerfel_open_ipopt() {
  auto session = std::make_unique<wuerfel::Session>();
  return session->start() ? session.release() : nullptr;
}
