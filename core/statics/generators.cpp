#include "core/statics/generators.h"

#include <algorithm>

#include "core/dynamics/programs.h"

namespace wuerfel {
namespace {

/// The same bodies, on surfaces of which none is smooth.
System rough(const System& system) {
  System result = system;
  result.pairs.clear();
  for (Body& body : result.bodies)
    body.material.friction = 1.0;
  result.rubs = true;
  return result;
}

/// The rows n and t of a contact become those of the edges n + mu t and n - mu t, all of about the
/// length of n.
void make_edges(const FrictionContact& contact, Generators& generators) {
  QuadraticProgram& p = generators.program;
  const double size = 1.0 / std::max(1.0, contact.mu);
  const int entries = p.row_start[contact.normal + 1] - p.row_start[contact.normal];
  double* n = p.coefficients.data() + p.row_start[contact.normal] * p.block_size;
  double* t = p.coefficients.data() + p.row_start[contact.tangent] * p.block_size;
  for (int k = 0; k < entries * p.block_size; ++k) {
    const double normal = size * n[k];
    const double along = size * contact.mu * t[k];
    n[k] = normal + along;
    t[k] = normal - along;
  }
  p.force_min[contact.tangent] = 0.0;
  ForceShare& of_n = generators.share[contact.normal];
  of_n = {of_n.contact, size, size * contact.mu};
  generators.share[contact.tangent] = {of_n.contact, size, -size * contact.mu};
}

}  // namespace

Generators find_generators(const System& system,
                           const State& state,
                           const Island& island,
                           Sliding sliding) {
  const System of = sliding == Sliding::none ? rough(system) : system;
  ProgramBuilder builder(of, Formulation::rigid);
  builder.acceleration(state, island);
  if (of.rubs) builder.add_friction(state, island);
  Generators generators{builder.program(), {}};
  QuadraticProgram& p = generators.program;
  std::ranges::fill(p.bound, 0.0);
  std::ranges::fill(p.target, 0.0);
  generators.share.resize(p.rows());
  for (int k = 0; k < static_cast<int>(island.contacts.size()); ++k)
    generators.share[builder.first_contact_row() + k] = {k, 1.0, 0.0};
  if (!of.rubs) return generators;
  const FrictionProgram friction = builder.friction_program();
  for (int k = 0; k < static_cast<int>(island.contacts.size()); ++k) {
    const FrictionContact& contact = friction.contacts[builder.friction_contact()[k]];
    if (contact.tangent < 0) continue;
    generators.share[contact.tangent] = {k, 0.0, 1.0};
    if (sliding == Sliding::given) make_edges(contact, generators);
  }
  return generators;
}

}  // namespace wuerfel
