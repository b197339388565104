#include "core/qp/methods/canonical_multipliers.h"

#include <algorithm>
#include <cmath>

#include "core/qp/block/quad_vector.h"

namespace wuerfel {
namespace {

/// Rows are tight up to this many times the residual of the solution, and between these shares of the
/// largest acceleration: where nearly dependent rows meet x is less exact than its residual, and an
/// open row taken for a tight one may carry a force in other solutions than this one.
constexpr double slack_times = 1e3;
constexpr double least_slack = 1e-12;
constexpr double most_slack = 1e-9;
constexpr double good_balance = 1e-11;  ///< forces of least norm are shown if they balance so well
/// In units of 1 / |g|^2. Rows that part from the others by an angle a keep the share (1 + 1e12 a^2)^-9 after the
/// most rounds: from 2.3e-6 on they have no part.
constexpr double projection_weight = 1e12;
constexpr int projection_rounds = 9;
constexpr double no_part = 1e-7;   ///< of a vector of numbers in [1, 2]
constexpr double no_force = 1e-9;  ///< of the largest on a body
constexpr double no_way = 1e-11;   ///< of a vector of numbers in [0, 1]

}  // namespace

CanonicalMultipliers::CanonicalMultipliers(const BlockKernels& kernels) : tight_(kernels) {}

void CanonicalMultipliers::find(const QuadraticProgram& program,
                                const std::vector<double>& x,
                                const std::vector<double>& multiplier,
                                bool with_unique,
                                LeastNormMultipliers& result) {
  result.multiplier = multiplier;
  result.unique.assign(multiplier.size(), false);
  meter_.measure_scales(program);
  keep_tight_rows(program, x, result.multiplier);
  balance_rows(program, x, result.multiplier);
  least_norm_.run(tight_, target_, scale_);
  for (std::size_t k = 0; k < row_.size(); ++k)
    result.multiplier[row_[k]] = least_norm_.multiplier()[k];
  result.misfit = meter_.imbalance(program, x, result.multiplier);
  if (with_unique) find_flags(result);
  if (result.misfit <= good_balance) return;
  const double given = meter_.imbalance(program, x, multiplier);
  if (given >= result.misfit) return;
  result.multiplier = multiplier;
  result.misfit = given;
}

/// The rows that may carry force, in `row_`; `multiplier` of the others becomes what their slack makes
/// it.
void CanonicalMultipliers::keep_tight_rows(const QuadraticProgram& program,
                                           const std::vector<double>& x,
                                           std::vector<double>& multiplier) {
  const ResidualScales& scales = meter_.scales();
  const double residual = meter_.measure(program, x, multiplier).worst();
  const double tight_slack = std::clamp(slack_times * residual, least_slack, most_slack);
  double force = scales.weight;
  for (int row = 0; row < program.rows(); ++row)
    force = std::max(force, std::abs(multiplier[row]) * scales.row_norm[row]);
  row_.clear();
  for (int row = 0; row < program.rows(); ++row) {
    const double slack = program.slack(row, x);
    const double norm = scales.row_norm[row];
    const double bound = slack > 0.0 ? program.force_min[row] : program.force_max[row];
    const double distance = std::abs(multiplier[row] - bound) * norm;
    const double gap = std::abs(slack) / norm;
    if (gap <= tight_slack * scales.acceleration || gap * force < distance * scales.acceleration) {
      row_.push_back(row);
    } else {
      multiplier[row] = bound;
    }
  }
}

/// The tight rows as a program with the masses 1, what they have to balance and in which scale.
void CanonicalMultipliers::balance_rows(const QuadraticProgram& program,
                                        const std::vector<double>& x,
                                        const std::vector<double>& multiplier) {
  const int size = program.block_size;
  program_.clear(size);
  program_.mass = program.mass;
  program_.target.assign(program.mass.size(), 0.0);
  force_ = program.mass;
  for (int j = 0; j < program.unknowns(); ++j) {
    program_.mass[j] /= program.mass[j - j % size];
    force_[j] *= x[j] - program.target[j];
  }
  std::size_t next = 0;
  for (int row = 0; row < program.rows(); ++row) {
    if (next < row_.size() && row_[next] == row) {
      ++next;
      program_.add_row(0.0, program.force_min[row], program.force_max[row]);
      for (int e = program.row_start[row]; e < program.row_start[row + 1]; ++e)
        program_.add_entry(program.entry_block[e], program.entry(e));
    } else if (multiplier[row] != 0.0) {
      program.add_row_force(row, -multiplier[row], force_);
    }
  }
  tight_.prepare(program_);
  tight_.pack(force_, target_);
  for (int j = 0; j < program.unknowns(); ++j)
    force_[j] = program.mass[j] * program.target[j];
  tight_.pack(force_, d_);
  scale_.clear();
  for (const Quad& weight : d_)
    scale_.push_back(largest(weight));
}

void CanonicalMultipliers::find_flags(LeastNormMultipliers& result) {
  weight_.resize(row_.size());
  for (std::size_t i = 0; i < row_.size(); ++i)
    weight_[i] = tight_.square()[i] > 0.0 ? projection_weight / tight_.square()[i] : 0.0;
  std::vector<char> dependent;
  if (mark_dependent(dependent) && find_support()) mark_dependent(dependent);
  result.unique.assign(result.multiplier.size(), true);
  for (std::size_t k = 0; k < row_.size(); ++k)
    if (dependent[k] != 0) result.unique[row_[k]] = false;
}

/// Takes the weight of rows that carry no force in any solution. False if there are none.
///
/// Solutions differ by vectors v with G' v = 0 that lead away from the bounds of the rows that are at
/// them in one solution. Of these v the one that is nearest to leading them all away shows some that
/// can go, as long as there are any.
bool CanonicalMultipliers::find_support() {
  const std::vector<double> least = least_norm_.multiplier();
  std::vector<double> away(least.size(), 0.0);
  for (std::size_t i = 0; i < least.size(); ++i) {
    const double idle = no_force * least_norm_.row_scale()[i];
    if (least[i] <= tight_.force_min()[i] + idle) away[i] = 1.0;
    if (least[i] >= tight_.force_max()[i] - idle) away[i] = -1.0;
    program_.force_min[i] = away[i] > 0.0 ? 0.0 : -unbounded;
    program_.force_max[i] = away[i] < 0.0 ? 0.0 : unbounded;
  }
  target_.assign(target_.size(), Quad{});
  scale_.assign(scale_.size(), 1.0);
  const auto is_held = [&](std::size_t i) { return away[i] != 0.0; };
  bool found = true;
  while (found) {
    tight_.prepare(program_);
    least_norm_.run(tight_, target_, scale_, away);
    found = false;
    for (std::size_t i = 0; i < away.size(); ++i) {
      if (!is_held(i) || std::abs(least_norm_.multiplier()[i]) <= no_way) continue;
      away[i] = 0.0;
      program_.force_min[i] = -unbounded;
      program_.force_max[i] = unbounded;
      found = true;
    }
  }
  bool any = false;
  for (std::size_t i = 0; i < away.size(); ++i) {
    if (is_held(i)) weight_[i] = 0.0;
    any = any || is_held(i);
  }
  return any;
}

/// v := v - W^(1/2) G (I + G' W G)^-1 G' W^(1/2) v, which leaves of v what no combination of
/// columns of G can take away. Returns the largest change.
double CanonicalMultipliers::project() {
  for (std::size_t i = 0; i < v_.size(); ++i)
    part_[i] = v_[i] * std::sqrt(weight_[i]);
  tight_.apply_transposed(part_.data(), d_.data());
  tight_.solve(d_.data());
  tight_.apply(d_.data(), part_.data());
  double change = 0.0;
  for (std::size_t i = 0; i < v_.size(); ++i) {
    const double taken = std::sqrt(weight_[i]) * part_[i];
    v_[i] -= taken;
    change = std::max(change, std::abs(taken));
  }
  return change;
}

/// Marks rows with a weight that have a part in some v with G' v = 0. True if there are any.
bool CanonicalMultipliers::mark_dependent(std::vector<char>& dependent) {
  const int rows = tight_.rows();
  dependent.assign(rows, 0);
  part_.resize(rows);
  v_.resize(rows);
  tight_.factorise(weight_.data());
  // Not random at all, but no row can know: multiples of the golden section, modulo 1.
  double seed = 0.5;
  bool any = false;
  for (int probe = 0; probe < 2; ++probe) {
    for (int i = 0; i < rows; ++i) {
      seed += 0.6180339887498949;
      if (seed >= 1.0) seed -= 1.0;
      v_[i] = weight_[i] > 0.0 ? 1.0 + seed * seed : 0.0;
    }
    for (int round = 0; round < projection_rounds && project() > 1e-3 * no_part; ++round) {
    }
    for (int i = 0; i < rows; ++i) {
      if (std::abs(v_[i]) > no_part) {
        dependent[i] = 1;
        any = true;
      }
    }
  }
  return any;
}

}  // namespace wuerfel
