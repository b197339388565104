#include "core/qp/ipopt/ipopt_form.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace wuerfel {
namespace {

/// Relative violation that rounding cannot explain.
constexpr double contradiction = 1e-6;

}  // namespace

ScaledProgram scaled(const QuadraticProgram& p) {
  ScaledProgram s;
  for (int row = 0; row < p.rows(); ++row) {
    SparseRow g;
    double h = p.bound[row];
    double square = 0.0;
    for (int e = p.row_start[row]; e < p.row_start[row + 1]; ++e) {
      for (int c = 0; c < p.block_size; ++c) {
        const int column = p.entry_block[e] * p.block_size + c;
        const double J = p.entry(e)[c];
        const double value = J / std::sqrt(p.mass[column]);
        h -= J * p.target[column];
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

ElasticForm::ElasticForm(const QuadraticProgram& program, const ScaledProgram& scaled)
    : scaled_(scaled) {
  unknowns_ = program.unknowns();
  const std::vector<bool> kept = rows_to_keep(program);
  for (int row = 0; row < program.rows(); ++row)
    if (kept[row]) add_row(row, program.force_min[row], program.force_max[row]);
  y_.resize(unknowns_ + cost_.size());
  multiplier_.resize(source_.size());
}

void ElasticForm::solve(IpoptSession& session, IpoptBarrier barrier) {
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

void ElasticForm::read(const QuadraticProgram& program, QpResult& result) const {
  result.iterations = point_.iterations;
  result.x.resize(program.mass.size());
  for (std::size_t j = 0; j < result.x.size(); ++j)
    result.x[j] = program.target[j] + y_[j] * scaled_.size / std::sqrt(program.mass[j]);
  result.multiplier.assign(program.bound.size(), 0.0);
  for (std::size_t k = 0; k < source_.size(); ++k) {
    const std::size_t row = source_[k];
    result.multiplier[row] = std::clamp(multiplier_[k] * scaled_.size / scaled_.norm[row],
                                        program.force_min[row], program.force_max[row]);
  }
}

bool ElasticForm::infeasible(const QuadraticProgram& program) const {
  if (program.allows_rest()) return false;
  if (point_.infeasible) return true;
  std::vector<double> violation(program.bound.size());
  double worst = 0.0;
  for (int row = 0; row < program.rows(); ++row) {
    double slack = -scaled_.h[row];
    for (std::size_t e = 0; e < scaled_.g[row].columns.size(); ++e)
      slack += scaled_.g[row].values[e] * y_[scaled_.g[row].columns[e]];
    if (slack < 0.0 && program.force_max[row] == unbounded) violation[row] = -slack;
    if (slack > 0.0 && program.force_min[row] == -unbounded) violation[row] = slack;
    worst = std::max(worst, violation[row]);
  }
  double worst_kept = 0.0;
  for (const int row : source_)
    worst_kept = std::max(worst_kept, violation[row]);
  return worst > contradiction && worst_kept < 1e-3 * contradiction;
}

/// All but zero rows, rows without force, and equalities that repeat others: Ipopt wants
/// independent ones, no more of them than unknowns. A dropped row has multiplier zero; if it
/// contradicts the others, the residual shows it.
std::vector<bool> ElasticForm::rows_to_keep(const QuadraticProgram& program) {
  std::vector<SparseRow> equalities;
  std::vector<int> places;
  std::vector<bool> kept(program.bound.size());
  for (int row = 0; row < program.rows(); ++row) {
    const bool forceless = program.force_min[row] == 0.0 && program.force_max[row] == 0.0;
    kept[row] = !scaled_.g[row].columns.empty() && !forceless;
    if (!program.is_equality(row)) continue;
    equalities.push_back(scaled_.g[row]);
    places.push_back(row);
  }
  const std::vector<bool> independent = independent_rows(equalities, program.unknowns());
  int count = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    kept[places[k]] = independent[k];
    if (independent[k]) ++count;
  }
  // Ipopt does not look at the objective where equalities leave no freedom, and then has no
  // multipliers; an idle unknown helps.
  if (count == unknowns_) ++unknowns_;
  return kept;
}

void ElasticForm::add_row(int row, double force_min, double force_max) {
  const std::size_t source = row;
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

void ElasticForm::add_elastic(int place, double sign, double cost) {
  add_entry(place, unknowns_ + static_cast<int>(cost_.size()), sign);
  cost_.push_back(cost);
}

void ElasticForm::add_entry(int place, int column, double value) {
  row_.push_back(place);
  column_.push_back(column);
  value_.push_back(value);
}

}  // namespace wuerfel
