#include "core/dynamics/forces.h"

#include <Eigen/QR>

#include "core/dynamics/programs.h"
#include "core/dynamics/pull_back.h"
#include "core/qp/canonical_multipliers.h"

namespace wuerfel {
namespace {

/// What the sparse way leaves undone, the dense one does for programs that are not too large.
constexpr double good_misfit = 1e-8;
constexpr int largest_dense = 200;

/// Multipliers of least norm with the accelerations x, or, where none better are found, those given.
/// Returns their residual.
double choose(const QuadraticProgram& program,
              const std::vector<double>& x,
              const std::vector<double>& given,
              Uniqueness uniqueness,
              LeastNormMultipliers& least) {
  CanonicalMultipliers().find(program, x, given, uniqueness == Uniqueness::asked, least);
  if (least.misfit > good_misfit && program.rows() <= largest_dense) {
    least = least_norm_multipliers(program, x);
  }
  const double residual = optimality_residual(program, x, least.multiplier).worst();
  if (residual <= QpSettings{}.tolerance) return residual;
  const double of_given = optimality_residual(program, x, given).worst();
  if (of_given >= residual) return residual;
  least.multiplier = given;
  least.unique.assign(given.size(), false);
  return of_given;
}

}  // namespace

ContactForces canonical_forces(const System& system,
                               const State& state,
                               const Island& island,
                               const std::vector<Twist>& accelerations,
                               const IslandSolution& solution,
                               Uniqueness uniqueness) {
  std::vector<SideUse> use;
  std::vector<double> multiplier;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const bool active = solution.slacks[k] != unbounded;
    use.push_back(active ? SideUse::inequality : SideUse::none);
    if (active) multiplier.push_back(solution.forces[k]);
  }
  ProgramBuilder builder(system, Formulation::rigid);
  builder.acceleration(state, island, use);
  std::vector<double> x;
  for (const Twist& a : accelerations) {
    x.insert(x.end(), {a.linear.x(), a.linear.y(), a.angular});
  }
  LeastNormMultipliers least;
  ContactForces result{std::vector<double>(use.size(), 0.0), std::vector<char>(use.size(), 0)};
  result.residual = choose(builder.program(), x, multiplier, uniqueness, least);
  std::size_t row = 0;
  for (std::size_t k = 0; k < use.size(); ++k) {
    if (use[k] == SideUse::none) {
      result.unique[k] = 1;  // an opening contact has no force
      continue;
    }
    result.force[k] = least.multiplier[row];
    result.unique[k] = least.unique[row] ? 1 : 0;
    ++row;
  }
  return result;
}

std::array<double, rods_per_cube> rod_forces(const System& system,
                                             const State& state,
                                             int cube,
                                             const Twist& acceleration,
                                             const std::vector<Contact>& contacts,
                                             const std::vector<double>& forces) {
  const Body& body = system.body(cube);
  const BodyState& s = state[cube];
  const CubePoints points = points_of(s, body.size);
  const auto masses = mass_distribution(body.size, body.mass);
  // What rods have to add to gravity and contact so that m_k a_k comes out.
  Eigen::Matrix<double, 2 * points_per_cube, 1> missing;
  for (int k = 0; k < points_per_cube; ++k) {
    const auto n = static_cast<std::size_t>(k);
    const Vec2 r = points.p[n] - s.position;
    const Vec2 a_k = point_acceleration(acceleration, s.spin, r);
    missing.segment<2>(2 * k) = masses[n].mass * (a_k - system.gravity);
  }
  for (std::size_t m = 0; m < contacts.size(); ++m) {
    const Contact& c = contacts[m];
    const SideRow row = normal_row(system, state, c, Order::velocity);
    if (c.on == cube) missing.segment<2>(2 * c.corner) -= forces[m] * row.g_k;
    if (c.from == cube) {
      missing.segment<2>(2 * next_corner(c.side)) -= forces[m] * row.g_i;
      missing.segment<2>(2 * c.side) -= forces[m] * row.g_j;
    }
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
