#include "core/time/events/motion_piece.h"

namespace wuerfel {

void pack(const State& state, std::vector<double>& y) {
  y.resize(components * state.size());
  double* at = y.data();
  for (const BodyState& s : state) {
    at[0] = s.position.x();
    at[1] = s.position.y();
    at[2] = s.angle;
    at[3] = s.velocity.x();
    at[4] = s.velocity.y();
    at[5] = s.spin;
    at += components;
  }
}

void unpack(const std::vector<double>& y, State& state) {
  const double* at = y.data();
  for (BodyState& s : state) {
    s.position = {at[0], at[1]};
    s.angle = at[2];
    s.velocity = {at[3], at[4]};
    s.spin = at[5];
    at += components;
  }
}

void look_at(const DenseStep& motion, double share, State& state) {
  std::size_t at = 0;
  for (BodyState& s : state) {
    s.position = {motion.component(share, at), motion.component(share, at + 1)};
    s.angle = motion.component(share, at + 2);
    s.velocity = {motion.component(share, at + 3), motion.component(share, at + 4)};
    s.spin = motion.component(share, at + 5);
    at += components;
  }
}

}  // namespace wuerfel
