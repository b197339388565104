#include "core/time/reference/algorithm_1.h"

#include "core/dynamics/momentum_balance.h"
#include "core/model/points.h"
#include "core/time/reference/active_restrictions.h"
#include "core/time/reference/length_correction.h"

namespace wuerfel {
namespace {

/// v := v + a dt,  p := p + v dt,  with the old v as printed, or with the new one. The same for an
/// angle and its rate.
template <class T>
void euler_step(T& p, T& v, const T& a, double dt, bool as_printed) {
  const T v_old = v;
  v += a * dt;
  p += (as_printed ? v_old : v) * dt;
}

void move_cubes(GridPoint& point, double dt, bool as_printed, const Workspace& work) {
  for (std::size_t i = 0; i < point.state.size(); ++i) {
    if (point.resting[i] != 0) continue;
    BodyState& s = point.state[i];
    const Twist& a = point.accelerations[i];
    const Body& body = work.system->bodies[i];
    if (work.formulation == Formulation::rigid || body.kind == BodyKind::point) {
      euler_step(s.position, s.velocity, a.linear, dt, as_printed);
      euler_step(s.angle, s.spin, a.angular, dt, as_printed);
      continue;
    }
    // To the letter: every point moves by itself, and the rods are put right afterwards.
    CubePoints points = points_of(s, body.size);
    for (std::size_t k = 0; k < points.p.size(); ++k) {
      const Vec2 r = points.p[k] - s.position;
      euler_step(points.p[k], points.v[k], point_acceleration(a, s.spin, r), dt, as_printed);
    }
    s = nearest_cube(points, body.size, body.mass, s);
  }
}

}  // namespace

void step_by_algorithm_1(
    GridPoint& point, double dt, bool as_printed, Workspace& work, Bookkeeping& book) {
  // Bestimme die aktiven Restriktionen: done when this point was reached.
  // Bestimme (a_i)
  accelerate(point, work, book);
  std::vector<Contact> pressed;
  for (std::size_t m = 0; m < point.islands.size(); ++m) {
    add_pressed(point.islands[m], point.solutions[m], pressed);
    point.push += dt * push_of(*work.system, point.state, point.islands[m], point.solutions[m]);
  }
  // v_{i+1} := v_i + a_i dt,  p_{i+1} := p_i + v_i dt
  move_cubes(point, dt, as_printed, work);
  // Eventuell Längenkorrektur
  point.push += correct_lengths(point.state, pressed, work, book);
  point.t += dt;
  find_restrictions(point, work, book);
}

}  // namespace wuerfel
