#include "core/qp/ipopt_solver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <dlfcn.h>

#include "core/qp/independent_rows.h"
#include "core/qp/least_norm_multipliers.h"

namespace wuerfel {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

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
  for (const std::string& path : std::array{folder + file, folder + "../lib/" + file, file}) {
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

/// The program in the unknowns y = M^(1/2) (x - f) / size, with rows of unit length:
///
///     minimise 1/2 |y|^2  subject to  g y >= h,  g = J M^(-1/2) / norm,  h = (b - J f) / (norm
///     size)
///
/// A multiplier of J is the one of g times size / norm. A row whose force is bounded may be missed
/// at the price of the bound: elastic unknowns p, q >= 0 with g y + p - q >= h.
struct ScaledProgram {
  std::vector<SparseRow> g;
  std::vector<double> h;
  std::vector<double> norm;
  double size = 1.0;
};

ScaledProgram scaled(const QuadraticProgram& p) {
  ScaledProgram s;
  for (int row = 0; row < p.rows(); ++row) {
    SparseRow g;
    double h = p.bound[at(row)];
    double square = 0.0;
    for (int e = p.row_start[at(row)]; e < p.row_start[at(row) + 1]; ++e) {
      for (int c = 0; c < p.block_size; ++c) {
        const int column = p.entry_block[at(e)] * p.block_size + c;
        const double J = p.entry(e)[at(c)];
        const double value = J / std::sqrt(p.mass[at(column)]);
        h -= J * p.target[at(column)];
        if (value == 0.0) continue;
        square += value * value;
        g.columns.push_back(column);
        g.values.push_back(value);
      }
    }
    const double norm = square > 0.0 ? std::sqrt(square) : 1.0;
    for (double& value : g.values)
      value /= norm;
    s.g.push_back(std::move(g));
    s.h.push_back(h / norm);
    s.norm.push_back(norm);
  }
  double size = 0.0;
  for (std::size_t row = 0; row < s.h.size(); ++row)
    if (p.force_min[row] < 0.0 || s.h[row] > 0.0) size = std::max(size, std::abs(s.h[row]));
  s.size = size > 0.0 ? size : 1.0;
  for (double& h : s.h)
    h /= s.size;
  return s;
}

/// Relative violation that rounding cannot explain.
constexpr double contradiction = 1e-6;

/// Owns what an IpoptProgram points to.
class ElasticForm {
 public:
  ElasticForm(const QuadraticProgram& program, const ScaledProgram& scaled) : scaled_(scaled) {
    unknowns_ = program.unknowns();
    const std::vector<bool> kept = rows_to_keep(program);
    for (int row = 0; row < program.rows(); ++row)
      if (kept[at(row)]) add_row(row, program.force_min[at(row)], program.force_max[at(row)]);
    y_.resize(at(unknowns_) + cost_.size());
    multiplier_.resize(source_.size());
  }

  void solve(IpoptSession& session, IpoptBarrier barrier) {
    IpoptProgram program;
    program.unknowns = unknowns_;
    program.elastics = static_cast<int>(cost_.size());
    program.rows = static_cast<int>(source_.size());
    program.entries = static_cast<int>(row_.size());
    program.cost = cost_.data();
    program.lower = lower_.data();
    program.upper = upper_.data();
    program.row = row_.data();
    program.column = column_.data();
    program.value = value_.data();
    point_.y = y_.data();
    point_.multiplier = multiplier_.data();
    point_.infeasible = false;
    session.solve(program, barrier, point_);
  }

  void read(const QuadraticProgram& program, QpResult& result) const {
    result.iterations = point_.iterations;
    result.x.resize(program.mass.size());
    for (std::size_t j = 0; j < result.x.size(); ++j)
      result.x[j] = program.target[j] + y_[j] * scaled_.size / std::sqrt(program.mass[j]);
    result.multiplier.assign(program.bound.size(), 0.0);
    for (std::size_t k = 0; k < source_.size(); ++k) {
      const std::size_t row = at(source_[k]);
      result.multiplier[row] = std::clamp(multiplier_[k] * scaled_.size / scaled_.norm[row],
                                          program.force_min[row], program.force_max[row]);
    }
  }

  /// Whether Ipopt saw no feasible point, or a row that was left out contradicts those that hold.
  [[nodiscard]] bool infeasible(const QuadraticProgram& program) const {
    if (point_.infeasible) return true;
    std::vector<double> violation(program.bound.size());
    double worst = 0.0;
    for (int row = 0; row < program.rows(); ++row) {
      double slack = -scaled_.h[at(row)];
      for (std::size_t e = 0; e < scaled_.g[at(row)].columns.size(); ++e)
        slack += scaled_.g[at(row)].values[e] * y_[at(scaled_.g[at(row)].columns[e])];
      if (slack < 0.0 && program.force_max[at(row)] == unbounded) violation[at(row)] = -slack;
      if (slack > 0.0 && program.force_min[at(row)] == -unbounded) violation[at(row)] = slack;
      worst = std::max(worst, violation[at(row)]);
    }
    double worst_kept = 0.0;
    for (const int row : source_)
      worst_kept = std::max(worst_kept, violation[at(row)]);
    return worst > contradiction && worst_kept < 1e-3 * contradiction;
  }

 private:
  /// All but zero rows, rows without force, and equalities that repeat others: Ipopt wants
  /// independent ones, no more of them than unknowns. A dropped row has multiplier zero; if it
  /// contradicts the others, the residual shows it.
  [[nodiscard]] std::vector<bool> rows_to_keep(const QuadraticProgram& program) {
    std::vector<SparseRow> equalities;
    std::vector<int> places;
    std::vector<bool> kept(program.bound.size());
    for (int row = 0; row < program.rows(); ++row) {
      const bool forceless = program.force_min[at(row)] == 0.0 && program.force_max[at(row)] == 0.0;
      kept[at(row)] = !scaled_.g[at(row)].columns.empty() && !forceless;
      if (!program.is_equality(row)) continue;
      equalities.push_back(scaled_.g[at(row)]);
      places.push_back(row);
    }
    const std::vector<bool> independent = independent_rows(equalities, program.unknowns());
    int count = 0;
    for (std::size_t k = 0; k < places.size(); ++k) {
      kept[at(places[k])] = independent[k];
      if (independent[k]) ++count;
    }
    // Ipopt does not look at the objective where equalities leave no freedom, and then has no
    // multipliers; an idle unknown helps.
    if (count == unknowns_) ++unknowns_;
    return kept;
  }

  void add_row(int row, double force_min, double force_max) {
    const std::size_t source = at(row);
    const int place = static_cast<int>(source_.size());
    source_.push_back(row);
    for (std::size_t e = 0; e < scaled_.g[source].columns.size(); ++e)
      add_entry(place, scaled_.g[source].columns[e], scaled_.g[source].values[e]);
    lower_.push_back(force_max > 0.0 ? scaled_.h[source] : -1e20);
    upper_.push_back(force_min < 0.0 ? scaled_.h[source] : 1e20);
    const double unit = scaled_.norm[source] / scaled_.size;
    if (force_max > 0.0 && force_max < unbounded) add_elastic(place, 1.0, force_max * unit);
    if (force_min < 0.0 && force_min > -unbounded) add_elastic(place, -1.0, -force_min * unit);
  }

  void add_elastic(int place, double sign, double cost) {
    add_entry(place, unknowns_ + static_cast<int>(cost_.size()), sign);
    cost_.push_back(cost);
  }

  void add_entry(int place, int column, double value) {
    row_.push_back(place);
    column_.push_back(column);
    value_.push_back(value);
  }

  const ScaledProgram& scaled_;
  IpoptPoint point_;
  int unknowns_ = 0;
  std::vector<int> source_, row_, column_;
  std::vector<double> cost_, lower_, upper_, value_, y_, multiplier_;
};

/// The program's point of least |y| on the rows that `result` leaves less slack than `tight` (in
/// units of h). An interior point stays sqrt(mu) away from rows that carry no force; this removes
/// the rest.
std::vector<double> onto_tight_rows(const QuadraticProgram& program,
                                    const ScaledProgram& form,
                                    const QpResult& result,
                                    double tight) {
  Eigen::MatrixXd g(program.rows(), program.unknowns());
  Eigen::VectorXd h(program.rows());
  Eigen::VectorXd y(program.unknowns());
  for (int j = 0; j < program.unknowns(); ++j)
    y[j] = (result.x[at(j)] - program.target[at(j)]) * std::sqrt(program.mass[at(j)]) / form.size;
  Eigen::Index count = 0;
  for (int row = 0; row < program.rows(); ++row) {
    const SparseRow& sparse = form.g[at(row)];
    g.row(count).setZero();
    for (std::size_t e = 0; e < sparse.columns.size(); ++e)
      g(count, sparse.columns[e]) = sparse.values[e];
    h[count] = form.h[at(row)];
    if (!sparse.columns.empty() && std::abs(g.row(count).dot(y) - h[count]) <= tight) ++count;
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> projection;
  projection.setThreshold(1e-10);
  projection.compute(g.topRows(count));
  y = projection.solve(h.head(count));
  std::vector<double> x = program.target;
  for (std::size_t j = 0; j < x.size(); ++j)
    x[j] += y[static_cast<Eigen::Index>(j)] * form.size / std::sqrt(program.mass[j]);
  return x;
}

/// Residual below which the rows that look tight are worth a try.
constexpr double worth_polishing = 0.1;

/// How wrong the accelerations of single bodies may be, the light ones among them, for which the
/// residual has no eye: the unbalance as an acceleration, and per row the violation or the smaller
/// of its slack and what its own force would move.
double local_error(const QuadraticProgram& p, const ScaledProgram& form, const QpResult& result) {
  std::vector<double> unbalance(result.x.size());
  for (std::size_t j = 0; j < result.x.size(); ++j)
    unbalance[j] = result.x[j] - p.target[j];
  double error = 0.0;
  for (int row = 0; row < p.rows(); ++row) {
    const SparseRow& g = form.g[at(row)];
    const double lambda = result.multiplier[at(row)];
    double slack = -p.bound[at(row)];
    double push = 0.0;
    double size = 0.0;
    for (std::size_t e = 0; e < g.columns.size(); ++e) {
      const std::size_t j = at(g.columns[e]);
      const double J = g.values[e] * form.norm[at(row)] * std::sqrt(p.mass[j]);
      slack += J * result.x[j];
      push += J * J / p.mass[j];
      size = std::max(size, std::abs(J));
      unbalance[j] -= J * lambda / p.mass[j];
    }
    const double distance =
        slack > 0.0 ? lambda - p.force_min[at(row)] : p.force_max[at(row)] - lambda;
    if (size > 0.0 && distance != 0.0)
      error = std::max(error, std::min(std::abs(slack), distance * push) / size);
  }
  for (const double u : unbalance)
    error = std::max(error, std::abs(u));
  return error;
}

/// Cubic in the number of unknowns, so for small programs only.
constexpr int largest_to_polish = 400;
/// An error of accelerations, relative to the size of the scaled program, that needs no polishing.
constexpr double exact_enough = 1e-13;

constexpr double good_residual = 1e-10;

/// Keeps the better of `result` and its projections onto the rows that look tight.
void polish(const QuadraticProgram& program, const ScaledProgram& form, QpResult& result) {
  if (program.unknowns() > largest_to_polish || program.rows() > 2 * largest_to_polish) return;
  double error = local_error(program, form, result);
  if (error <= exact_enough * form.size) return;
  QpResult candidate;
  for (const double tight : {1e-6, 1e-8}) {
    candidate.x = onto_tight_rows(program, form, result, tight);
    candidate.multiplier =
        least_norm_multipliers(program, candidate.x, {}, {.tight = tight}).multiplier;
    candidate.residual = optimality_residual(program, candidate.x, candidate.multiplier);
    const double candidate_error = local_error(program, form, candidate);
    // While the residual is poor it decides; once it is good, the light bodies do.
    const double worst = candidate.residual.worst();
    const bool better = result.residual.worst() > good_residual
                            ? worst < result.residual.worst()
                            : worst <= good_residual && candidate_error < error;
    if (!better) continue;
    error = candidate_error;
    result.x = candidate.x;
    result.multiplier = candidate.multiplier;
    result.residual = candidate.residual;
  }
}

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
  if (program.rows() == 0) {
    result.x = program.target;
    result.multiplier.clear();
    result.residual = optimality_residual(program, result.x, result.multiplier);
    result.status = QpStatus::optimal;
    return;
  }
  if (!open()) {
    result.status = QpStatus::unavailable;
    return;
  }
  const ScaledProgram form = scaled(program);
  // Degenerate programs defeat now the one, now the other way to lower the barrier.
  for (const IpoptBarrier barrier : {IpoptBarrier::monotone, IpoptBarrier::adaptive}) {
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
