#include "core/dynamics/forces.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

#include "core/dynamics/programs.h"
#include "core/dynamics/rod_rows.h"
#include "core/qp/coulomb/canonical_friction.h"
#include "core/qp/coulomb/coulomb_solver.h"
#include "core/qp/methods/canonical_multipliers.h"

namespace wuerfel {
namespace {

/// The contacts that were active in a solution.
std::vector<SideUse> uses(const IslandSolution& solution) {
  std::vector<SideUse> use;
  for (const double slack : solution.slacks)
    use.push_back(std::isfinite(slack) ? SideUse::inequality : SideUse::none);
  return use;
}

/// Forces of least norm with the accelerations x under friction, or, where none better are found, those given. Returns
/// their residual.
double choose(const FrictionProgram& friction,
              const std::vector<double>& x,
              const std::vector<double>& given,
              Uniqueness uniqueness,
              CanonicalForces& least) {
  least = canonical_friction(friction, x, given, uniqueness == Uniqueness::asked);
  const double residual = coulomb_residual(friction, x, least.multiplier).worst();
  if (residual <= CoulombSettings{}.tolerance) return residual;
  least.unique.assign(least.unique.size(), false);
  const double of_given = coulomb_residual(friction, x, given).worst();
  if (of_given < residual) least.multiplier = given;
  return std::min(residual, of_given);
}

/// The forces of rods, which come first of all rows.
void take_rods(const std::vector<double>& multiplier,
               const std::vector<bool>& unique,
               std::size_t rods,
               ContactForces& result) {
  const auto count = static_cast<std::ptrdiff_t>(rods);
  result.rods.assign(multiplier.begin(), multiplier.begin() + count);
  result.rods_unique.assign(unique.begin(), unique.begin() + count);
}

}  // namespace

double ContactForces::least_pressing() const {
  return force.empty() ? 0.0 : pressing_share * std::ranges::max(force);
}

ContactForces canonical_forces(const System& system,
                               const State& state,
                               const Island& island,
                               const std::vector<Twist>& accelerations,
                               const IslandSolution& solution,
                               Uniqueness uniqueness) {
  const std::vector<SideUse> use = uses(solution);
  std::vector<double> multiplier = solution.rods;
  multiplier.resize(island.rods.size(), 0.0);
  for (std::size_t k = 0; k < use.size(); ++k)
    if (use[k] != SideUse::none) multiplier.push_back(solution.forces[k]);
  ProgramBuilder builder(system, Formulation::rigid);
  builder.acceleration(state, island, use);
  const std::vector<double> x = unknowns_of(accelerations);
  const LeastNormMultipliers least =
      canonical_multipliers(builder.program(), x, multiplier, uniqueness == Uniqueness::asked);
  ContactForces result{std::vector<double>(use.size(), 0.0), std::vector<char>(use.size(), 1)};
  std::size_t row = island.rods.size();
  take_rods(least.multiplier, least.unique, row, result);
  for (std::size_t k = 0; k < use.size(); ++k) {
    if (use[k] == SideUse::none) continue;  // no force, and only that one
    result.force[k] = least.multiplier[row];
    result.unique[k] = least.unique[row] ? 1 : 0;
    ++row;
  }
  result.residual =
      std::max(least.misfit, optimality_residual(builder.program(), x, least.multiplier).worst());
  return result;
}

ContactForces canonical_forces_with_friction(const System& system,
                                             const State& state,
                                             const Island& island,
                                             const std::vector<int>& slides,
                                             const std::vector<Twist>& accelerations,
                                             const IslandSolution& solution,
                                             Uniqueness uniqueness) {
  const std::vector<SideUse> use = uses(solution);
  ProgramBuilder builder(system, Formulation::rigid);
  builder.acceleration(state, island, use);
  builder.add_friction(state, island, slides);
  const FrictionProgram friction = builder.friction_program();
  const std::vector<int>& number = builder.friction_contact();
  std::vector<double> multiplier(friction.program.rows(), 0.0);
  std::ranges::copy(solution.rods, multiplier.begin() + builder.first_rod_row());
  for (std::size_t k = 0; k < use.size(); ++k) {
    if (number[k] < 0) continue;
    const FrictionContact& c = friction.contacts[number[k]];
    multiplier[c.normal] = solution.forces[k];
    if (c.tangent >= 0) multiplier[c.tangent] = solution.tangential[k];
  }
  CanonicalForces least;
  ContactForces result{std::vector<double>(use.size(), 0.0), std::vector<char>(use.size(), 1),
                       std::vector<double>(use.size(), 0.0)};
  result.residual = choose(friction, unknowns_of(accelerations), multiplier, uniqueness, least);
  const auto rods = static_cast<std::ptrdiff_t>(friction.contacts.size());
  take_rods(least.multiplier, {least.unique.begin() + rods, least.unique.end()}, island.rods.size(),
            result);
  for (std::size_t k = 0; k < use.size(); ++k) {
    if (number[k] < 0) continue;  // an opening contact has no force
    const FrictionContact& c = friction.contacts[number[k]];
    result.force[k] = least.multiplier[c.normal];
    if (c.tangent >= 0) result.tangential[k] = least.multiplier[c.tangent];
    result.unique[k] = least.unique[number[k]] ? 1 : 0;
  }
  return result;
}

std::array<double, rods_per_cube> rod_forces(const System& system,
                                             const State& state,
                                             int cube,
                                             const Twist& acceleration,
                                             const Island& island,
                                             const ContactForces& forces) {
  const Body& body = system.body(cube);
  const BodyState& s = state[cube];
  const CubePoints points = points_of(s, body.size);
  const auto masses = mass_distribution(body.size, body.mass);
  // What rods have to add to gravity and contact so that m_k a_k comes out.
  Eigen::Matrix<double, 2 * points_per_cube, 1> missing;
  for (int k = 0; k < points_per_cube; ++k) {
    const Vec2 r = points.p[k] - s.position;
    const Vec2 a_k = point_acceleration(acceleration, s.spin, r);
    missing.segment<2>(2 * k) = masses[k].mass * (a_k - system.gravity);
  }
  const auto push = [&](const Contact& c, const SideRow& row, double force) {
    if (c.on == cube) missing.segment<2>(2 * c.corner) -= force * row.g_k;
    if (c.from == cube) {
      missing.segment<2>(2 * next_corner(c.side)) -= force * row.g_i;
      missing.segment<2>(2 * c.side) -= force * row.g_j;
    }
  };
  const std::vector<Contact>& contacts = island.contacts;
  for (std::size_t m = 0; m < contacts.size(); ++m) {
    push(contacts[m], normal_row(system, state, contacts[m], Order::velocity), forces.force[m]);
    if (forces.tangential.empty()) continue;
    push(contacts[m], tangential_row(system, state, contacts[m], Order::velocity),
         forces.tangential[m]);
  }
  const auto hold = [&](const RodEnd& end, const Vec2& force) {
    if (end.body != cube) return;
    const auto share = share_of_points(end.at, body.size);
    for (int k = 0; k < points_per_cube; ++k)
      missing.segment<2>(2 * k) -= share[k] * force;
  };
  for (std::size_t m = 0; m < island.rods.size(); ++m) {
    const Rod& rod = system.rods[island.rods[m]];
    const Vec2 force = forces.rods[m] * rod_direction(rod, state);
    hold(rod.i, force);
    hold(rod.j, -force);
  }
  Eigen::Matrix<double, 2 * points_per_cube, rods_per_cube> directions;
  directions.setZero();
  for (int m = 0; m < rods_per_cube; ++m) {
    const RodEnds& rod = cube_rods[m];
    const Vec2 pull = (points.p[rod.j] - points.p[rod.i]).normalized();
    directions.block<2, 1>(2 * rod.i, m) = pull;
    directions.block<2, 1>(2 * rod.j, m) = -pull;
  }
  const Eigen::Matrix<double, rods_per_cube, 1> tension =
      directions.completeOrthogonalDecomposition().solve(missing);
  std::array<double, rods_per_cube> result{};
  for (int m = 0; m < rods_per_cube; ++m) {
    result[m] = tension[m];
  }
  return result;
}

}  // namespace wuerfel
