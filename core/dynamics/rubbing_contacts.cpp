#include "core/dynamics/rubbing_contacts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Dense>

#include "core/dynamics/rod_rows.h"
#include "core/qp/methods/equality_solver.h"

namespace wuerfel {
namespace {

/// Pivots of independent rows are larger than this share of the largest.
constexpr double safe_pivot = 1e-3;

/// Rows contradict one another where accelerations miss them by more than this share of what has to be made up for.
constexpr double contradiction_share = 1e-8;

/// One row after the other, so that one can be handed on.
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Dense rows R, columns C', bounds, for the cubes of an island.
struct Equations {
  Rows rows;
  Rows columns;
  Eigen::VectorXd bound;
  Eigen::VectorXd target;
  Eigen::VectorXd inverse_mass;
};

/// Adds a multiple of what a row asks of a body; nothing of one that is fixed.
void add(const Island& island,
         int body,
         const std::array<double, 3>& g,
         double factor,
         Eigen::Ref<Eigen::RowVectorXd> out) {
  const auto cube = std::ranges::lower_bound(island.cubes, body);
  if (cube == island.cubes.end() || *cube != body) return;
  const auto at = 3 * (cube - island.cubes.begin());
  for (int i = 0; i < 3; ++i)
    out[at + i] += factor * g[i];
}

/// Adds a multiple of a row, less its constant.
void add(const Island& island,
         const Contact& contact,
         const ContactRow& row,
         double factor,
         const Eigen::Ref<Eigen::RowVectorXd>& out) {
  add(island, contact.on, row.on, factor, out);
  add(island, contact.from, row.from, factor, out);
}

void set_targets(
    const System& system, const State& state, const Island& island, Order order, Equations& e) {
  const auto n = static_cast<Eigen::Index>(3 * island.cubes.size());
  e.target = Eigen::VectorXd::Zero(n);
  e.inverse_mass.resize(n);
  int at = 0;
  for (const int cube : island.cubes) {
    const Body& body = system.body(cube);
    const BodyState& s = state[cube];
    e.inverse_mass.segment<3>(at) << 1.0 / body.mass, 1.0 / body.mass, 1.0 / body.inertia;
    if (order == Order::acceleration) e.target.segment<2>(at) = system.gravity;
    if (order == Order::velocity) e.target.segment<3>(at) << s.velocity.x(), s.velocity.y(), s.spin;
    at += 3;
  }
}

/// Once refined.
template <class Factors>
Eigen::VectorXd refined(const Factors& factors,
                        const Eigen::MatrixXd& matrix,
                        const Eigen::VectorXd& b) {
  Eigen::VectorXd x = factors.solve(b);
  x += factors.solve(b - matrix * x);
  return x;
}

/// Of least squares where rows depend on one another. That is asked only where pivots are small: it takes three times as
/// long.
Eigen::VectorXd least_solution(const Eigen::MatrixXd& matrix,
                               const Eigen::VectorXd& b,
                               bool& redundant) {
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(matrix);
  const auto pivots = lu.matrixLU().diagonal().cwiseAbs();
  redundant = false;
  if (pivots.minCoeff() > safe_pivot * pivots.maxCoeff()) return refined(lu, matrix, b);
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors;
  factors.setThreshold(dependent_share);
  factors.compute(matrix);
  redundant = factors.rank() < matrix.rows();
  return refined(factors, matrix, b);
}

/// R C', of whose rows each knows two cubes at most.
Eigen::MatrixXd product(const Rows& rows, const Rows& columns) {
  Eigen::MatrixXd product = Eigen::MatrixXd::Zero(rows.rows(), columns.rows());
  for (Eigen::Index at = 0; at < rows.cols(); at += 3) {
    for (Eigen::Index k = 0; k < rows.rows(); ++k) {
      const Eigen::Vector3d g = rows.row(k).segment<3>(at);
      if (!g.isZero(0.0)) product.row(k) += columns.middleCols<3>(at) * g;
    }
  }
  return product;
}

/// lambda of R M^-1 C' lambda = b - R f, with rows and columns of size one.
Eigen::VectorXd multipliers(const Equations& e, bool& redundant) {
  const Eigen::VectorXd root = e.inverse_mass.cwiseSqrt();
  Rows rows = e.rows * root.asDiagonal();
  Rows columns = e.columns * root.asDiagonal();
  const Eigen::VectorXd row_unit = rows.rowwise().norm().cwiseInverse();
  const Eigen::VectorXd column_unit = columns.rowwise().norm().cwiseInverse();
  rows = row_unit.asDiagonal() * rows;
  columns = column_unit.asDiagonal() * columns;
  const Eigen::MatrixXd coupling = product(rows, columns);
  const Eigen::VectorXd b = row_unit.cwiseProduct(e.bound - e.rows * e.target);
  return column_unit.cwiseProduct(least_solution(coupling, b, redundant));
}

}  // namespace

void RubbingContacts::close(std::span<const Touch> touches) {
  touches_.assign(touches.begin(), touches.end());
  any_ = std::ranges::any_of(touches_, [](const Touch& t) { return t.sticks || t.slips != 0; });
}

void RubbingContacts::solve(const System& system,
                            const State& state,
                            const Island& island,
                            Order order,
                            std::vector<double>& x,
                            std::vector<double>& forces) {
  const auto sticking = std::ranges::count_if(touches_, &Touch::sticks);
  const auto normals = static_cast<Eigen::Index>(island.contacts.size());
  Equations e;
  set_targets(system, state, island, order, e);
  const auto rods = static_cast<Eigen::Index>(island.rods.size());
  e.rows = Rows::Zero(normals + sticking + rods, e.target.size());
  e.columns = e.rows;
  e.bound = Eigen::VectorXd::Zero(normals + sticking + rods);
  const auto along = [&](Contact c, const Touch& touch) {
    c.slip = touch.sticks ? place_along(system, c) - touch.anchor : 0.0;
    return pull_back(system, state, c, order, tangential_row(system, state, c, order));
  };
  Eigen::Index next = normals;
  for (const Touch& touch : touches_) {
    for (int k = touch.first; k < touch.first + touch.count; ++k) {
      const Contact& c = island.contacts[k];
      const ContactRow row =
          pull_back(system, state, c, order, normal_row(system, state, c, order));
      add(island, c, row, 1.0, e.rows.row(k));
      e.columns.row(k) = e.rows.row(k);
      e.bound[k] = -row.c;
      if (touch.slips == 0 || order != Order::acceleration) continue;
      add(island, c, along(c, touch), -touch.slips * touch.surface.friction, e.columns.row(k));
    }
    if (!touch.sticks) continue;
    const Contact& c = island.contacts[touch.first];
    const ContactRow row = along(c, touch);
    add(island, c, row, 1.0, e.rows.row(next));
    e.columns.row(next) = e.rows.row(next);
    e.bound[next++] = -row.c;
  }
  for (const int number : island.rods) {
    const Rod& rod = system.rods[number];
    const BodyRodRow row = rod_row(rod, state, order);
    add(island, rod.i.body, row.i, 1.0, e.rows.row(next));
    add(island, rod.j.body, row.j, 1.0, e.rows.row(next));
    e.columns.row(next) = e.rows.row(next);
    e.bound[next++] = -row.c;
  }
  const Eigen::VectorXd lambda = multipliers(e, redundant_);
  const Eigen::VectorXd found =
      e.target + e.inverse_mass.cwiseProduct(e.columns.transpose() * lambda);
  if (order == Order::acceleration) {
    const Eigen::VectorXd missed = (e.rows * found - e.bound).head(normals + sticking);
    const Eigen::VectorXd due = e.bound - e.rows * e.target;
    contradict_ =
        redundant_
        && missed.lpNorm<Eigen::Infinity>() > contradiction_share * due.lpNorm<Eigen::Infinity>();
  }
  x.assign(found.begin(), found.end());
  forces.assign(lambda.begin(), lambda.begin() + normals);
  tangential_.assign(lambda.begin() + normals, lambda.begin() + normals + sticking);
}

bool RubbingContacts::drives(std::span<const double> forces, double rounding) const {
  return std::ranges::any_of(touches_, [&](const Touch& touch) {
    const auto own = forces.subspan(touch.first, touch.count);
    return touch.slips != 0 && std::accumulate(own.begin(), own.end(), 0.0) < -rounding;
  });
}

void RubbingContacts::add_margins(std::span<const double> forces,
                                  std::vector<double>& loads) const {
  std::size_t next = 0;
  for (const Touch& touch : touches_) {
    if (!touch.sticks) continue;
    double normal = 0.0;
    for (int k = touch.first; k < touch.first + touch.count; ++k)
      normal += forces[k];
    const double along = tangential_[next++];
    const double most = touch.surface.friction * normal;
    loads.insert(loads.end(), {most - along, most + along});
  }
}

std::vector<double> RubbingContacts::along_sides(std::span<const double> forces) const {
  std::vector<double> along(forces.size(), 0.0);
  std::size_t next = 0;
  for (const Touch& touch : touches_) {
    if (touch.sticks) along[touch.first] = tangential_[next++];
    for (int k = touch.first; k < touch.first + touch.count && touch.slips != 0; ++k)
      along[k] = -touch.slips * touch.surface.friction * forces[k];
  }
  return along;
}

void RubbingContacts::add_slips(const System& system,
                                const State& state,
                                std::span<const Contact> contacts,
                                std::vector<double>& loads) const {
  for (const Touch& touch : touches_) {
    if (touch.slips != 0)
      loads.push_back(touch.slips * slip_rate(system, state, contacts[touch.first]));
  }
}

}  // namespace wuerfel
