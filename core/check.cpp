#include "core/check.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/forces_at.h"
#include "core/model/scales.h"
#include "core/time/reference/active_restrictions.h"
#include "core/time/start_state.h"

namespace wuerfel {
namespace {

/// Shares of g (design, "Verdict"): below the first a cube stands, above the second it falls.
constexpr double stands_below = 1e-10;
constexpr double falls_above = 1e-9;

/// The largest |a| + side |alpha| of any cube, as a share of g, or of the scale in its place.
double largest_share(const System& system, const State& state, const std::vector<Twist>& a) {
  double e = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    e = std::max(e, a[i].linear.norm() + system.bodies[i].size.minCoeff() * std::abs(a[i].angular));
  }
  const double g = system.gravity.norm();
  return e / (g > 0.0 ? g : scales_of(system, state).gravity);
}

Verdict judge(const System& system, const State& state, const InstantForces& found) {
  const bool moves = std::ranges::any_of(
      state, [](const BodyState& s) { return !s.velocity.isZero(0.0) || s.spin != 0.0; });
  if (moves) return Verdict::moves;
  if (!found.solved) return Verdict::undecided;
  const double e = largest_share(system, state, found.accelerations);
  if (e <= stands_below) return Verdict::stands;
  return e >= falls_above ? Verdict::falls : Verdict::undecided;
}

void add_contact_forces(const System& system, const IslandForces& of, Check& check) {
  for (std::size_t k = 0; k < of.island.contacts.size(); ++k) {
    const Contact& c = of.island.contacts[k];
    check.contacts.push_back({system.body(c.on).name, system.body(c.from).name, c.point, c.normal,
                              of.forces.force[k], 0.0, of.forces.unique[k] != 0});
  }
}

}  // namespace

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::stands:
      return "stands";
    case Verdict::falls:
      return "falls";
    case Verdict::moves:
      return "moves";
    case Verdict::undecided:
      return "undecided";
  }
  return "?";
}

Check check(const Scene& scene, const MotionSettings& settings) {
  const System system = make_system(scene);
  GridPoint start;
  start.state = start_state(scene);
  Bookkeeping impacts;
  ActiveRestrictions(system, settings).find(start, impacts);
  const InstantForces found = forces_at(system, settings, start.state, Detail::uniqueness);

  Check check;
  check.verdict = judge(system, start.state, found);
  if (impacts.audit.missed_solves > 0 && check.verdict != Verdict::moves)
    check.verdict = Verdict::undecided;
  check.kkt_residual = found.residual;
  check.accelerations = found.accelerations;
  for (int i = 0; i < system.cubes; ++i) {
    const Body& body = system.body(i);
    const Twist& a = check.accelerations[i];
    check.objective += body.mass * (a.linear - system.gravity).squaredNorm()
                       + body.inertia * a.angular * a.angular;
  }
  for (const IslandForces& of : found.islands)
    add_contact_forces(system, of, check);
  return check;
}

}  // namespace wuerfel
