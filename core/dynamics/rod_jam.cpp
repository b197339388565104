#include "core/dynamics/rod_jam.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include <Eigen/SVD>

#include "core/dynamics/impact.h"
#include "core/dynamics/rod_consistency.h"
#include "core/dynamics/rod_rows.h"

namespace wuerfel {
namespace {

/// Each round takes half of what bends the rods apart: so many leave nothing but rounding.
constexpr int most_rounds = 55;
/// Sets of rods that contradict each other, one after the other.
constexpr int most_sets = 16;
/// What is left of velocities, as a share of what was there; of b(v) its square.
constexpr double rounding = 1e-13;

/// Rods that depend on one another: sum lambda_k g_k = 0.
struct Stress {
  std::vector<int> rods;
  std::vector<double> lambda;
};

Stress stress_of(const System& system, const State& state, const Island& island) {
  ProgramBuilder builder(system, Formulation::rigid);
  builder.velocity(state, island);
  const QuadraticProgram& program = builder.program();
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(program.unknowns(), program.rows());
  for (int row = 0; row < program.rows(); ++row)
    program.add_row_force(row, 1.0, J.col(row));
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(J, Eigen::ComputeFullV);
  const Eigen::VectorXd last = svd.matrixV().col(program.rows() - 1);
  return {island.rods, {last.data(), last.data() + last.size()}};
}

/// b(v) = sum lambda_k c_k(v)
double bend_of(const System& system, const State& state, const Stress& stress) {
  double b = 0.0;
  for (std::size_t k = 0; k < stress.rods.size(); ++k)
    b += stress.lambda[k] * rod_row(system.rods[stress.rods[k]], state, Order::acceleration).c;
  return b;
}

/// Derivative of b(v) by the velocity or spin (`part` 0 .. 2) of a cube; `unit` is a change of a size like v.
double bend_rate(const System& system,
                 const State& state,
                 const Stress& stress,
                 int cube,
                 int part,
                 double unit) {
  const auto at = [&](double change) {
    State moved = state;
    BodyState& s = moved[cube];
    (part < 2 ? s.velocity[part] : s.spin) += change;
    return bend_of(system, moved, stress);
  };
  return (at(unit) - at(-unit)) / (2.0 * unit);
}

double fastest_of(const System& system, const State& state, const std::vector<int>& cubes) {
  double fastest = 0.0;
  for (const int cube : cubes)
    fastest = std::max(fastest, fastest_corner(system.body(cube), state[cube]));
  return fastest;
}

/// Adds the row <b'(v), w> = b(v) for the next velocities w: by the homogeneity of b half of <b'(v), v>.
void add_bend_row(const System& system,
                  const State& state,
                  const Island& island,
                  const Stress& stress,
                  QuadraticProgram& program) {
  const double speed = fastest_of(system, state, island.cubes);
  std::vector<std::array<double, 3>> rates;
  double square = 0.0;
  for (const int cube : island.cubes) {
    const double radius = system.body(cube).radius();
    const double spin = radius > 0.0 ? speed / radius : 0.0;
    auto& rate = rates.emplace_back();
    for (int part = 0; part < 3; ++part) {
      const double unit = part < 2 ? speed : spin;
      rate[part] = unit > 0.0 ? bend_rate(system, state, stress, cube, part, unit) : 0.0;
      square += rate[part] * rate[part];
    }
  }
  const double size = std::sqrt(square);
  if (size == 0.0) return;
  program.add_equality(bend_of(system, state, stress) / size);
  program.row_name.push_back(std::numeric_limits<std::int64_t>::max());
  for (int k = 0; k < std::ssize(rates); ++k) {
    for (double& r : rates[k])
      r /= size;
    program.add_entry(k, rates[k]);
  }
}

/// An impact of an island round by round.
class Rounds {
 public:
  Rounds(const System& system, State state, const Island& island)
      : system_(&system),
        island_(&island),
        now_(std::move(state)),
        builder_(system, Formulation::rigid),
        solver_(make_qp_solver(QpMethod::automatic)) {
    sum_.status = QpStatus::optimal;
    sum_.forces.assign(island.contacts.size(), 0.0);
    sum_.slacks.assign(island.contacts.size(), 0.0);
    sum_.rods.assign(island.rods.size(), 0.0);
  }

  /// Takes from the velocities what a set of rods cannot go on with.
  void straighten(const Stress& stress) {
    const double allowed = rounding * rounding * std::abs(bend_of(*system_, now_, stress));
    for (int k = 0; k < most_rounds && std::abs(bend_of(*system_, now_, stress)) > allowed; ++k)
      if (!strike(stress)) return;
  }

  [[nodiscard]] const State& now() const { return now_; }

  /// Velocities of rounding become zero.
  IslandSolution end(const State& start) {
    const double zero = rounding * fastest_of(*system_, start, island_->cubes);
    for (const int cube : island_->cubes) {
      BodyState& s = now_[cube];
      if (fastest_corner(system_->body(cube), s) <= zero) stop(s);
      sum_.twists.push_back({s.velocity, s.spin});
    }
    return std::move(sum_);
  }

 private:
  bool strike(const Stress& stress) {
    builder_.velocity(now_, *island_);
    QuadraticProgram program = builder_.program();
    add_bend_row(*system_, now_, *island_, stress, program);
    solver_->solve(program, result_);
    sum_.iterations += result_.iterations;
    if (result_.status != QpStatus::optimal && result_.status != QpStatus::inaccurate) return false;
    sum_.residual = std::max(sum_.residual, result_.residual.worst());
    if (result_.status == QpStatus::inaccurate) sum_.status = result_.status;
    set_velocities(*island_, builder_.twists(now_, *island_, result_.x), now_);
    const double* multiplier = result_.multiplier.data();
    for (double& impulse : sum_.rods)
      impulse += *multiplier++;
    for (double& impulse : sum_.forces)
      impulse += *multiplier++;
    return true;
  }

  const System* system_;
  const Island* island_;
  State now_;
  ProgramBuilder builder_;
  std::unique_ptr<QpSolver> solver_;
  QpResult result_;
  IslandSolution sum_;
};

}  // namespace

RodJam rod_jam(const System& system, const State& state, const Island& island) {
  RodJam jam;
  jam.rods = rods_of_island(system, state, island).contradicting;
  if (jam.rods.empty()) return jam;
  Rounds rounds(system, state, island);
  std::vector<int> set = jam.rods;
  for (int k = 0; k < most_sets && !set.empty(); ++k) {
    rounds.straighten(stress_of(system, rounds.now(), {island.cubes, {}, {}, set}));
    set = rods_of_island(system, rounds.now(), island).contradicting;
  }
  jam.hit.after = rounds.end(state);
  jam.hit.loss =
      kinetic_energy(system, state, island) - kinetic_energy(system, rounds.now(), island);
  return jam;
}

}  // namespace wuerfel
