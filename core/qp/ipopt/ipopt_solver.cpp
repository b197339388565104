#include "core/qp/ipopt/ipopt_solver.h"

#include <array>
#include <dlfcn.h>

#include "core/qp/ipopt/ipopt_form.h"
#include "core/qp/ipopt/ipopt_polish.h"

namespace wuerfel {
namespace {

/// The folder of the program or library that this code is part of, with a final '/'.
std::string own_folder() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&own_folder), &info) == 0 || info.dli_fname == nullptr)
    return "";
  const std::string file = info.dli_fname;
  const std::size_t slash = file.rfind('/');
  return slash == std::string::npos ? "" : file.substr(0, slash + 1);
}

/// The module's entry: beside the program, in lib/ beside its folder, or on the run path. Once open
/// it stays so.
OpenIpopt find_module(std::string& trouble) {
  const std::string file = ipopt_module_file;
  const std::string folder = own_folder();
  const std::array paths{folder + file, folder + "../lib/" + file, file};
  for (const std::string& path : paths) {
    void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (module == nullptr) {
      trouble = dlerror();
    } else if (void* symbol = dlsym(module, ipopt_module_symbol); symbol != nullptr) {
      trouble.clear();
      return reinterpret_cast<OpenIpopt>(symbol);
    }
  }
  trouble =
      "the Ipopt module " + file + " cannot be loaded (" + trouble
      + "); install coinor-libipopt1v5 and keep the module beside the program or in its ../lib";
  return nullptr;
}

/// Residual below which the rows that look tight are worth a try.
constexpr double worth_polishing = 0.1;

}  // namespace

bool IpoptSolver::open() {
  if (session_) return true;
  if (OpenIpopt open_session = find_module(trouble_); open_session != nullptr) {
    session_.reset(open_session());
    if (!session_)
      trouble_ = "Ipopt does not accept its settings; version 3.11 or newer with MUMPS is needed";
  }
  return session_ != nullptr;
}

void IpoptSolver::solve(const QuadraticProgram& program, QpResult& result) {
  result = {QpStatus::invalid, std::move(result.x), std::move(result.multiplier), {}, 0};
  trouble_ = defect(program);
  if (!trouble_.empty()) return;
  solve_checked(program, result);
}

void IpoptSolver::solve_checked(const QuadraticProgram& program, QpResult& result) {
  // A target that keeps all rows is the answer. Ipopt comes near to it only, and where nothing accelerates there is no
  // scale by which that were near enough.
  result.x = program.target;
  result.multiplier.assign(program.bound.size(), 0.0);
  result.residual = optimality_residual(program, result.x, result.multiplier);
  if (result.residual.worst() == 0.0) {
    result.status = QpStatus::optimal;
    return;
  }
  if (!open()) {
    result.status = QpStatus::unavailable;
    return;
  }
  const ScaledProgram form = scaled(program);
  // Degenerate programs defeat now the one, now the other way to lower the barrier; which of them
  // depends on the last bits of the BLAS that Ipopt finds.
  for (const IpoptBarrier barrier :
       {IpoptBarrier::monotone, IpoptBarrier::adaptive, IpoptBarrier::far}) {
    ElasticForm elastic(program, form);
    elastic.solve(*session_, barrier);
    elastic.read(program, result);
    result.residual = optimality_residual(program, result.x, result.multiplier);
    if (result.residual.worst() < worth_polishing) polish(program, form, result);
    result.status = result.residual.worst() <= settings_.tolerance ? QpStatus::optimal
                    : elastic.infeasible(program)                  ? QpStatus::infeasible
                                                                   : QpStatus::inaccurate;
    if (result.status == QpStatus::optimal) return;
  }
}

}  // namespace wuerfel
