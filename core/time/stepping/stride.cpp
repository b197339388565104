#include "core/time/stepping/stride.h"

#include <cmath>

namespace wuerfel {

void add_blows(const System& system,
               const std::vector<Box>& start_boxes,
               const std::vector<Contact>& contacts,
               Stride& stride) {
  for (const Contact& c : contacts) {
    const auto at = stride.blows.lower_bound(c.id());
    if (at == stride.blows.end() || at->first != c.id())
      stride.blows.emplace_hint(at, c.id(), Blow{at_poses(system, start_boxes, c), c});
  }
}

std::vector<Contact> acting(const Stride& stride) {
  std::vector<Contact> acting;
  for (const auto& [id, blow] : stride.blows) {
    if (blow.acts()) acting.push_back(blow.end);
  }
  return acting;
}

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
