#include "core/qp/coulomb/convex_relaxation.h"

#include <algorithm>

namespace wuerfel {
namespace {

/// A unit of force along an edge of the cone: rows of about the norm of the normal one for any mu.
double edge_scale(double mu) { return 1.0 / std::max(1.0, mu); }

bool has_cone(const FrictionContact& contact) { return contact.tangent >= 0 && contact.mu > 0.0; }

}  // namespace

ConvexRelaxation::ConvexRelaxation(double tolerance)
    : solver_(make_qp_solver(QpMethod::automatic, {.tolerance = tolerance})) {}

QpStatus ConvexRelaxation::solve(const FrictionProgram& friction) {
  build(friction);
  solver_->solve(convex_, result_);
  // A solver that refuses the program leaves what it found for another one.
  if (result_.multiplier.size() == convex_.bound.size()) {
    read(friction);
  } else {
    multiplier_.assign(friction.program.bound.size(), 0.0);
  }
  return result_.status;
}

void ConvexRelaxation::build(const FrictionProgram& friction) {
  const QuadraticProgram& p = friction.program;
  convex_.clear(p.block_size);
  convex_.mass = p.mass;
  convex_.target = p.target;
  single_.clear();
  std::vector<char> replaced(p.bound.size(), 0);
  for (const FrictionContact& contact : friction.contacts) {
    if (contact.tangent >= 0) replaced[contact.tangent] = 1;
    if (has_cone(contact)) replaced[contact.normal] = 1;
  }
  for (int row = 0; row < p.rows(); ++row) {
    if (replaced[row] != 0) continue;
    single_.push_back(row);
    convex_.add_row(p.bound[row], p.force_min[row], p.force_max[row]);
    for (int e = p.row_start[row]; e < p.row_start[row + 1]; ++e)
      convex_.add_entry(p.entry_block[e], p.entry(e));
  }
  for (const FrictionContact& contact : friction.contacts)
    if (has_cone(contact)) add_edges(p, contact);
}

/// Adds a multiple of a row to the one at hand.
void ConvexRelaxation::add_row(const QuadraticProgram& p, int row, double factor) {
  for (int e = p.row_start[row]; e < p.row_start[row + 1]; ++e) {
    const auto found = std::find(block_.begin(), block_.end(), p.entry_block[e]);
    const auto at = found - block_.begin();
    if (found == block_.end()) {
      block_.push_back(p.entry_block[e]);
      coefficients_.resize(coefficients_.size() + p.entry(e).size(), 0.0);
    }
    for (int c = 0; c < p.block_size; ++c)
      coefficients_[at * p.block_size + c] += factor * p.coefficients[e * p.block_size + c];
  }
}

/// Rows  J_n +- mu J_t >= b_n +- mu b_t, scaled; of a contact that is known to slip the edge against its slip.
void ConvexRelaxation::add_edges(const QuadraticProgram& p, const FrictionContact& contact) {
  const double scale = edge_scale(contact.mu);
  for (const double sign : {1.0, -1.0}) {
    if (sign * contact.slides > 0.0) continue;
    const double f = sign * contact.mu * scale;
    block_.clear();
    coefficients_.clear();
    add_row(p, contact.normal, scale);
    add_row(p, contact.tangent, f);
    convex_.add_inequality(scale * p.bound[contact.normal] + f * p.bound[contact.tangent]);
    for (int k = 0; k < static_cast<int>(block_.size()); ++k) {
      convex_.add_entry(block_[k], {coefficients_.data() + k * p.block_size,
                                    coefficients_.data() + (k + 1) * p.block_size});
    }
  }
}

void ConvexRelaxation::read(const FrictionProgram& friction) {
  multiplier_.assign(friction.program.bound.size(), 0.0);
  const auto singles = static_cast<int>(single_.size());
  for (int k = 0; k < singles; ++k)
    multiplier_[single_[k]] = result_.multiplier[k];
  int next = singles;
  for (const FrictionContact& contact : friction.contacts) {
    if (!has_cone(contact)) continue;
    const double scale = edge_scale(contact.mu);
    double along = 0.0;
    for (const double sign : {1.0, -1.0}) {
      if (sign * contact.slides > 0.0) continue;
      const double force = scale * result_.multiplier[next++];
      multiplier_[contact.normal] += force;
      along += sign * force;
    }
    multiplier_[contact.tangent] = contact.mu * along;
  }
}

}  // namespace wuerfel
