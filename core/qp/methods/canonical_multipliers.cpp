#include "core/qp/methods/canonical_multipliers.h"

#include <algorithm>
#include <cmath>

#include "core/qp/block/least_distance.h"
#include "core/qp/block/quad_vector.h"
#include "core/qp/methods/least_norm_method.h"
#include "core/qp/residual_meter.h"

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
constexpr double no_part = 1e-7;  ///< of a vector of numbers in [1, 2]
constexpr double no_way = 1e-11;  ///< of a vector of numbers in [0, 1]

/// The rows that may carry force alone, with masses of one kilogram: the multipliers must balance
/// J' lambda, whatever the masses are, and without their ratios the rows are much more alike.
struct TightProgram {
  std::vector<int> row;  ///< of the whole program
  QuadraticProgram program;
  LeastDistance problem{best_block_kernels()};  ///< of `program`
  std::vector<Quad> force;                      ///< that these rows have to balance
  std::vector<double> weight;                   ///< of the bodies, in the order of `force`
};

/// The rows that may carry force; `multiplier` of the others becomes what their slack makes it.
std::vector<int> find_tight_rows(const QuadraticProgram& program,
                                 const std::vector<double>& x,
                                 ResidualMeter& meter,
                                 std::vector<double>& multiplier) {
  const ResidualScales& scales = meter.measure_scales(program);
  const double residual = meter.measure(program, x, multiplier).worst();
  const double tight_slack = std::clamp(slack_times * residual, least_slack, most_slack);
  const double force = scales.largest_force(multiplier);
  std::vector<int> tight;
  for (int row = 0; row < program.rows(); ++row) {
    const double slack = program.slack(row, x);
    const double norm = scales.row_norm[row];
    const double bound = slack > 0.0 ? program.force_min[row] : program.force_max[row];
    const double distance = std::abs(multiplier[row] - bound) * norm;
    const double gap = std::abs(slack) / norm;
    if (gap <= tight_slack * scales.acceleration || gap * force < distance * scales.acceleration) {
      tight.push_back(row);
    } else {
      multiplier[row] = bound;
    }
  }
  return tight;
}

/// The rows `tight.row`, and what `multiplier` of the others leaves to them.
void balance_rows(const QuadraticProgram& program,
                  const std::vector<double>& x,
                  const std::vector<double>& multiplier,
                  TightProgram& tight) {
  const int size = program.block_size;
  QuadraticProgram& alone = tight.program;
  alone.clear(size);
  alone.mass = program.mass;
  alone.target.assign(program.mass.size(), 0.0);
  std::vector<double> force = program.mass;
  for (int j = 0; j < program.unknowns(); ++j) {
    alone.mass[j] /= program.mass[j - j % size];
    force[j] *= x[j] - program.target[j];
  }
  std::size_t next = 0;
  for (int row = 0; row < program.rows(); ++row) {
    if (next < tight.row.size() && tight.row[next] == row) {
      ++next;
      alone.add_row(0.0, program.force_min[row], program.force_max[row]);
      for (int e = program.row_start[row]; e < program.row_start[row + 1]; ++e)
        alone.add_entry(program.entry_block[e], program.entry(e));
    } else if (multiplier[row] != 0.0) {
      program.add_row_force(row, -multiplier[row], force);
    }
  }
  tight.problem.prepare(alone);
  tight.problem.pack(force, tight.force);
  for (int j = 0; j < program.unknowns(); ++j)
    force[j] = program.mass[j] * program.target[j];
  std::vector<Quad> weight;
  tight.problem.pack(force, weight);
  for (const Quad& w : weight)
    tight.weight.push_back(largest(w));
}

/// The tight rows that carry force in a solution: most of them do so in that of least norm, too.
std::vector<char> loaded_rows(const std::vector<int>& rows, const std::vector<double>& multiplier) {
  double most = 0.0;
  for (const int row : rows)
    most = std::max(most, std::abs(multiplier[row]));
  std::vector<char> loaded(rows.size());
  std::ranges::transform(rows, loaded.begin(), [&](int row) {
    return std::abs(multiplier[row]) > loaded_share * most ? 1 : 0;
  });
  return loaded;
}

/// An arbitrary vector on its way onto those v with G' v = 0, and room for one step of it.
struct Probe {
  std::vector<double> v, part;
  std::vector<Quad> d;
};

/// v := v - W^(1/2) G (I + G' W G)^-1 G' W^(1/2) v, which leaves of v what no combination of
/// columns of G can take away. Returns the largest change.
double project(const std::vector<double>& weight, LeastDistance& problem, Probe& probe) {
  auto& [v, part, d] = probe;
  for (std::size_t i = 0; i < v.size(); ++i)
    part[i] = v[i] * std::sqrt(weight[i]);
  problem.apply_transposed(part.data(), d.data());
  problem.solve(d.data());
  problem.apply(d.data(), part.data());
  double change = 0.0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double taken = std::sqrt(weight[i]) * part[i];
    v[i] -= taken;
    change = std::max(change, std::abs(taken));
  }
  return change;
}

/// The rows with a weight that have a part in some v with G' v = 0 are marked.
std::vector<char> dependent_rows(const std::vector<double>& weight, LeastDistance& problem) {
  const int rows = problem.rows();
  std::vector<char> dependent(rows, 0);
  Probe probe{std::vector<double>(rows), std::vector<double>(rows),
              std::vector<Quad>(problem.blocks())};
  problem.factorise(weight.data());
  // Not random at all, but no row can know: multiples of the golden section, modulo 1.
  double seed = 0.5;
  for (int k = 0; k < 2; ++k) {
    for (int i = 0; i < rows; ++i) {
      seed += 0.6180339887498949;
      if (seed >= 1.0) seed -= 1.0;
      probe.v[i] = weight[i] > 0.0 ? 1.0 + seed * seed : 0.0;
    }
    for (int round = 0; round < projection_rounds; ++round) {
      if (project(weight, problem, probe) <= 1e-3 * no_part) break;
    }
    for (int i = 0; i < rows; ++i)
      if (std::abs(probe.v[i]) > no_part) dependent[i] = 1;
  }
  return dependent;
}

/// The rows that carry no force in any solution are marked.
///
/// Solutions differ by vectors v with G' v = 0 that lead away from the bounds of the rows that are at
/// them in one solution. Of these v the one that is nearest to leading them all away shows some that
/// can go, as long as there are any.
std::vector<char> idle_rows(TightProgram& tight, LeastNormMethod& least_norm) {
  const std::vector<double> least = least_norm.multiplier();
  QuadraticProgram& program = tight.program;
  std::vector<double> away(least.size(), 0.0);
  for (std::size_t i = 0; i < least.size(); ++i) {
    const double idle = loaded_share * least_norm.row_scale()[i];
    if (least[i] <= tight.problem.force_min()[i] + idle) away[i] = 1.0;
    if (least[i] >= tight.problem.force_max()[i] - idle) away[i] = -1.0;
    program.force_min[i] = away[i] > 0.0 ? 0.0 : -unbounded;
    program.force_max[i] = away[i] < 0.0 ? 0.0 : unbounded;
  }
  const std::vector<Quad> nothing(tight.force.size());
  const std::vector<double> ones(tight.weight.size(), 1.0);
  bool found = true;
  while (found) {
    tight.problem.prepare(program);
    least_norm.run(tight.problem, nothing, ones, away);
    found = false;
    for (std::size_t i = 0; i < away.size(); ++i) {
      if (away[i] == 0.0 || std::abs(least_norm.multiplier()[i]) <= no_way) continue;
      away[i] = 0.0;
      program.force_min[i] = -unbounded;
      program.force_max[i] = unbounded;
      found = true;
    }
  }
  std::vector<char> idle(away.size());
  std::ranges::transform(away, idle.begin(), [](double way) { return way != 0.0 ? 1 : 0; });
  return idle;
}

bool any(const std::vector<char>& marks) { return std::ranges::find(marks, 1) != marks.end(); }

/// The tight rows whose multipliers in `least_norm` are not the only ones possible are marked. Leaves
/// ranges of multipliers as the search had them.
std::vector<char> ambiguous_rows(TightProgram& tight, LeastNormMethod& least_norm) {
  std::vector<double> weight;
  for (const double square : tight.problem.square())
    weight.push_back(square > 0.0 ? projection_weight / square : 0.0);
  std::vector<char> dependent = dependent_rows(weight, tight.problem);
  if (!any(dependent)) return dependent;
  const std::vector<char> idle = idle_rows(tight, least_norm);
  if (!any(idle)) return dependent;
  for (std::size_t i = 0; i < weight.size(); ++i)
    if (idle[i] != 0) weight[i] = 0.0;
  return dependent_rows(weight, tight.problem);
}

}  // namespace

LeastNormMultipliers canonical_multipliers(const QuadraticProgram& program,
                                           const std::vector<double>& x,
                                           const std::vector<double>& multiplier,
                                           bool with_unique) {
  LeastNormMultipliers result{multiplier, std::vector<bool>(multiplier.size(), false)};
  ResidualMeter meter;
  TightProgram tight;
  tight.row = find_tight_rows(program, x, meter, result.multiplier);
  balance_rows(program, x, result.multiplier, tight);
  LeastNormMethod least_norm;
  least_norm.run(tight.problem, tight.force, tight.weight, {}, loaded_rows(tight.row, multiplier));
  for (std::size_t k = 0; k < tight.row.size(); ++k)
    result.multiplier[tight.row[k]] = least_norm.multiplier()[k];
  result.misfit = meter.imbalance(program, x, result.multiplier);
  if (with_unique) {
    result.unique.assign(multiplier.size(), true);
    const std::vector<char> ambiguous = ambiguous_rows(tight, least_norm);
    for (std::size_t k = 0; k < tight.row.size(); ++k)
      if (ambiguous[k] != 0) result.unique[tight.row[k]] = false;
  }
  if (result.misfit <= good_balance) return result;
  const double given = meter.imbalance(program, x, multiplier);
  if (given >= result.misfit) return result;
  result.multiplier = multiplier;
  result.misfit = given;
  return result;
}

}  // namespace wuerfel
