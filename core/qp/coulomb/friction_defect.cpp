#include <cmath>

#include "core/qp/coulomb/coulomb_solver.h"

namespace wuerfel {
namespace {

/// What is wrong with the contacts; `taken` are the rows that belong to them.
std::string_view defect_of_contacts(const FrictionProgram& friction, std::vector<char>& taken) {
  const auto take = [&](int row) {
    if (row < 0 || row >= friction.program.rows() || taken[row] != 0) return false;
    taken[row] = 1;
    return true;
  };
  for (const FrictionContact& contact : friction.contacts) {
    if (!(contact.mu >= 0.0) || !std::isfinite(contact.mu))
      return "a coefficient of friction is bad";
    if (!take(contact.normal)) return "a contact has no normal row of its own";
    if (contact.tangent < 0 && contact.mu == 0.0) continue;
    if (!take(contact.tangent)) return "a contact has no tangential row of its own";
  }
  return {};
}

}  // namespace

std::string_view defect(const FrictionProgram& friction) {
  const QuadraticProgram& p = friction.program;
  const std::string_view of_program = defect(p);
  if (!of_program.empty()) return of_program;
  if (p.block_size > 3) return "a block has more than three unknowns";
  std::vector<char> taken(p.bound.size(), 0);
  const std::string_view of_contacts = defect_of_contacts(friction, taken);
  if (!of_contacts.empty()) return of_contacts;
  for (int row = 0; row < p.rows(); ++row) {
    const bool inequality = p.force_min[row] == 0.0 && p.force_max[row] == unbounded;
    if (taken[row] == 0 && !inequality && !p.is_equality(row))
      return "a row of no contact is neither an equality nor an inequality";
  }
  return {};
}

}  // namespace wuerfel
