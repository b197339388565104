#include "core/time/stepping/stride.h"

#include <cmath>

namespace wuerfel {

double closing_speed(const System& system, const Stride& stride, const Contact& contact) {
  const double rate = gap_rate(contact, contact_velocity(system, stride.start, contact));
  return -rate / (stride.scales.gravity * stride.h);
}

bool is_near(const System& system, const Contact& c, double share) {
  const bool on_side =
      system.body(c.from).kind == BodyKind::plane || (c.alpha >= 0.0 && c.alpha <= 1.0);
  return on_side && std::abs(c.gap) < share * contact_scale(system, c);
}

}  // namespace wuerfel
