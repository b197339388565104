#include "core/check.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/forces.h"
#include "core/time/first_moment.h"
#include "core/time/reference/stepper.h"

namespace wuerfel {
namespace {

/// Shares of g (design, "Verdict"): below the first a cube stands, above the second it falls.
constexpr double stands_below = 1e-10;
constexpr double falls_above = 1e-9;

Verdict judge(const System& system, const Moment& moment, const Audit& audit) {
  const bool moves = std::ranges::any_of(
      moment.state, [](const BodyState& s) { return !s.velocity.isZero(0.0) || s.spin != 0.0; });
  if (moves) return Verdict::moves;
  if (audit.missed_solves > 0) return Verdict::undecided;
  const double g = system.gravity.norm();
  double e = 0.0;
  for (std::size_t i = 0; i < moment.accelerations.size(); ++i) {
    const Twist& a = moment.accelerations[i];
    e = std::max(e, a.linear.norm() + system.bodies[i].size.minCoeff() * std::abs(a.angular));
  }
  if (g > 0.0) e /= g;
  if (e <= stands_below) return Verdict::stands;
  return e >= falls_above ? Verdict::falls : Verdict::undecided;
}

void add_contact_forces(const System& system, const Moment& moment, Check& check) {
  for (std::size_t m = 0; m < moment.islands.size(); ++m) {
    const Island& island = moment.islands[m];
    std::vector<Twist> accelerations;
    for (const int cube : island.cubes)
      accelerations.push_back(moment.accelerations[cube]);
    const ContactForces forces = canonical_forces(system, moment.state, island, accelerations,
                                                  moment.solutions[m], Uniqueness::asked);
    for (std::size_t k = 0; k < island.contacts.size(); ++k) {
      const Contact& c = island.contacts[k];
      check.contacts.push_back({system.body(c.on).name, system.body(c.from).name, c.point, c.normal,
                                forces.force[k], 0.0, forces.unique[k] != 0});
    }
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
  Moment moment = first_moment(scene);
  Bookkeeping book;
  Stepper stepper(system, settings);
  stepper.arrive(moment, book);
  stepper.accelerate(moment, book);

  Check check;
  check.verdict = judge(system, moment, book.audit);
  check.kkt_residual = book.audit.max_kkt_residual;
  for (std::size_t i = 0; i < moment.accelerations.size(); ++i) {
    const Twist& a = moment.accelerations[i];
    const Body& body = system.bodies[i];
    check.accelerations.push_back({a.linear, a.angular});
    check.objective += body.mass * (a.linear - system.gravity).squaredNorm()
                       + body.inertia * a.angular * a.angular;
  }
  add_contact_forces(system, moment, check);
  return check;
}

}  // namespace wuerfel
