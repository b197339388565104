#include "core/time/reference/algorithm_1.h"

#include "core/dynamics/momentum_balance.h"
#include "core/model/points.h"
#include "core/time/policy.h"

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

}  // namespace

Algorithm1::Algorithm1(const System& system, const MotionSettings& settings)
    : system_(&system),
      formulation_(settings.formulation),
      as_printed_(policy_of(settings).as_printed),
      restrictions_(system, settings),
      correction_(system, settings) {}

void Algorithm1::step(GridPoint& point, double dt, Bookkeeping& book) {
  // Bestimme die aktiven Restriktionen: done when this point was reached.
  // Bestimme (a_i)
  restrictions_.accelerate(point, book);
  std::vector<Contact> pressed;
  for (std::size_t m = 0; m < point.islands.size(); ++m) {
    add_pressed(point.islands[m], point.solutions[m], pressed);
    point.push += dt * push_of(*system_, point.state, point.islands[m], point.solutions[m]);
  }
  // v_{i+1} := v_i + a_i dt,  p_{i+1} := p_i + v_i dt
  integrate(point, dt);
  // Eventuell Längenkorrektur
  point.push += correction_.correct(point.state, pressed, book);
  point.t += dt;
  restrictions_.find(point, book);
}

void Algorithm1::integrate(GridPoint& point, double dt) const {
  for (std::size_t i = 0; i < point.state.size(); ++i) {
    if (point.resting[i] != 0) continue;
    BodyState& s = point.state[i];
    const Twist& a = point.accelerations[i];
    const bool is_point = system_->bodies[i].kind == BodyKind::point;
    if (formulation_ == Formulation::rigid || is_point) {
      euler_step(s.position, s.velocity, a.linear, dt, as_printed_);
      euler_step(s.angle, s.spin, a.angular, dt, as_printed_);
      continue;
    }
    // To the letter: every point moves by itself, and the rods are put right afterwards.
    const Body& body = system_->bodies[i];
    CubePoints points = points_of(s, body.size);
    for (std::size_t k = 0; k < points.p.size(); ++k) {
      const Vec2 r = points.p[k] - s.position;
      euler_step(points.p[k], points.v[k], point_acceleration(a, s.spin, r), dt, as_printed_);
    }
    s = nearest_cube(points, body.size, body.mass, s);
  }
}

}  // namespace wuerfel
