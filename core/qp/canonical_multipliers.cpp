#include "core/qp/canonical_multipliers.h"

#include <algorithm>
#include <cmath>

#include "core/qp/quad_vector.h"

namespace wuerfel {
namespace {

constexpr double tight_slack = 1e-9;  ///< relative as in QpResidual
constexpr int most_rounds =
    200;  ///< of the proximal iteration: back-solves, as long as the rows stay
constexpr int most_factorisations = 60;  ///< per round
constexpr double most_stiffness = 1e6;
constexpr double exact_balance = 1e-14;
constexpr double good_balance = 1e-9;
constexpr double projection_weight = 1e10;  ///< in units of 1 / |g|^2
constexpr int projection_rounds = 300;      ///< at most; nearly dependent rows take many
constexpr double no_part = 1e-7;            ///< of a vector of numbers in [1, 2]
constexpr double no_force = 1e-9;           ///< of the largest force, at an interior point

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double largest(const std::vector<Quad>& v) {
  double most = 0.0;
  for (const Quad& q : v)
    most = std::max({most, std::abs(q.v[0]), std::abs(q.v[1]), std::abs(q.v[2])});
  return most;
}

double slack_of(const QuadraticProgram& p, int row, const std::vector<double>& x) {
  double slack = -p.bound[at(row)];
  for (int e = p.row_start[at(row)]; e < p.row_start[at(row) + 1]; ++e) {
    for (int c = 0; c < p.block_size; ++c)
      slack += p.entry(e)[at(c)] * x[at(p.entry_block[at(e)] * p.block_size + c)];
  }
  return slack;
}

}  // namespace

CanonicalMultipliers::CanonicalMultipliers(const BlockKernels& kernels)
    : tight_(kernels), whole_(kernels) {}

void CanonicalMultipliers::find(const QuadraticProgram& program,
                                const std::vector<double>& x,
                                const std::vector<double>& multiplier,
                                bool with_unique,
                                LeastNormMultipliers& result) {
  result.multiplier = multiplier;
  result.unique.assign(multiplier.size(), false);
  result.misfit = 0.0;
  select(program, x, multiplier);
  tight_.prepare(program_);
  const bool found = find_values(result.misfit);
  if (found) {
    for (std::size_t k = 0; k < row_.size(); ++k)
      result.multiplier[at(row_[k])] = newton_.multiplier()[k];
  }
  if (with_unique) find_flags(program, result);
}

/// The rows that may carry force, with the multipliers given.
void CanonicalMultipliers::select(const QuadraticProgram& program,
                                  const std::vector<double>& x,
                                  const std::vector<double>& multiplier) {
  const ResidualScales& scales = meter_.measure_scales(program);
  kept_.assign(program.bound.size(), false);
  for (int row = 0; row < program.rows(); ++row) {
    kept_[at(row)] = program.is_equality(row)
                     || std::abs(slack_of(program, row, x))
                            <= tight_slack * scales.row_norm[at(row)] * scales.acceleration;
  }
  keep_rows(program, kept_);
  multiplier_.clear();
  for (const int row : row_)
    multiplier_.push_back(multiplier[at(row)]);
}

void CanonicalMultipliers::keep_rows(const QuadraticProgram& program,
                                     const std::vector<bool>& kept) {
  program_.clear(program.block_size);
  // The multipliers must balance J' lambda, whatever the masses are: without their ratios the rows
  // are much less alike.
  program_.mass = program.mass;
  for (std::size_t j = 0; j < program.mass.size(); ++j)
    program_.mass[j] /= program.mass[j - j % at(program.block_size)];
  program_.target = program.target;
  row_.clear();
  for (int row = 0; row < program.rows(); ++row) {
    if (!kept[at(row)]) continue;
    row_.push_back(row);
    program_.add_row(program.bound[at(row)], program.force_min[at(row)],
                     program.force_max[at(row)]);
    for (int e = program.row_start[at(row)]; e < program.row_start[at(row) + 1]; ++e)
      program_.add_entry(program.entry_block[at(e)], program.entry(e));
  }
}

bool CanonicalMultipliers::find_values(double& misfit) {
  double force = 0.0;
  for (const double lambda : multiplier_)
    force = std::max(force, std::abs(lambda));
  const auto blocks = at(tight_.blocks());
  y_.resize(blocks);
  d_.resize(blocks);
  tight_.apply_transposed(multiplier_.data(), y_.data());
  shift_ = y_;
  newton_.remember(tight_, multiplier_);
  const double size = largest(y_);
  misfit = size > 0.0 ? unbounded : 0.0;
  if (size == 0.0) return false;
  double stiffness = 1.0;
  int slow = 0;
  for (int round = 0; round < most_rounds && misfit > exact_balance; ++round) {
    if (!newton_.least_norm(tight_, shift_, stiffness, force, most_factorisations)) break;
    d_ = y_;
    add(-1.0, newton_.y(), d_);
    add(1.0, d_, shift_);
    const double now = largest(d_) / size;
    slow = now > 0.3 * misfit ? slow + 1 : 0;
    misfit = now;
    if (slow < 3) continue;
    // Nearly dependent rows need a stiffer penalty, as long as rounding allows it.
    slow = 0;
    stiffness *= 100.0;
    if (stiffness > most_stiffness) break;
    shift_ = y_;
  }
  return misfit <= good_balance;
}

void CanonicalMultipliers::find_flags(const QuadraticProgram& program,
                                      LeastNormMultipliers& result) {
  std::vector<bool> dependent;
  bool any = mark_dependent(dependent);
  if (any && find_support(program)) {
    tight_.prepare(program_);
    mark_dependent(dependent);
  }
  result.unique.assign(program.bound.size(), true);
  for (std::size_t k = 0; k < row_.size(); ++k)
    if (dependent[k]) result.unique[at(row_[k])] = false;
}

/// Leaves only the rows that carry force in some solution. False if the interior point did not get
/// there.
bool CanonicalMultipliers::find_support(const QuadraticProgram& program) {
  const ResidualScales& scales = meter_.measure_scales(program);
  whole_.prepare(program);
  // Nearer to the solution rounding would decide which of the redundant rows carry force.
  constexpr double near = 1e-10;
  const MethodOutcome outcome = interior_point_.run(whole_, scales, near, false, 1e-14);
  if (outcome.worst > near) return false;
  const std::vector<double>& lambda = interior_point_.multiplier();
  double force = 0.0;
  for (const int row : row_)
    force = std::max(force, std::abs(lambda[at(row)]));
  for (std::size_t row = 0; row < kept_.size(); ++row) {
    const double distance =
        std::min(lambda[row] - program.force_min[row], program.force_max[row] - lambda[row]);
    if (kept_[row]) kept_[row] = distance > no_force * force;
  }
  keep_rows(program, kept_);
  return true;
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

/// Marks rows of tight_ that have a part in some v with G' v = 0. True if there are any.
bool CanonicalMultipliers::mark_dependent(std::vector<bool>& dependent) {
  const auto rows = at(tight_.rows());
  dependent.assign(rows, false);
  weight_.resize(rows);
  part_.resize(rows);
  v_.resize(rows);
  for (std::size_t i = 0; i < rows; ++i)
    weight_[i] = tight_.square()[i] > 0.0 ? projection_weight / tight_.square()[i] : 0.0;
  tight_.factorise(weight_.data());
  // Not random at all, but no row can know: multiples of the golden section, modulo 1.
  double seed = 0.5;
  bool any = false;
  for (int probe = 0; probe < 2; ++probe) {
    for (double& v : v_) {
      seed += 0.6180339887498949;
      if (seed >= 1.0) seed -= 1.0;
      v = 1.0 + seed * seed;
    }
    for (int round = 0; round < projection_rounds && project() > 1e-3 * no_part; ++round) {
    }
    for (std::size_t i = 0; i < rows; ++i)
      if (std::abs(v_[i]) > no_part) dependent[i] = any = true;
  }
  return any;
}

}  // namespace wuerfel
