// States as vectors and back.
#include "core/time/events/motion_piece.h"

#include <gtest/gtest.h>

namespace wuerfel::test {
namespace {

TEST(MotionPiece, StatesArePackedComponentByComponent) {
  State state(2);
  state[0] = {{1.0, 2.0}, 3.0, {4.0, 5.0}, 6.0};
  state[1] = {{7.0, 8.0}, 9.0, {10.0, 11.0}, 12.0};
  std::vector<double> y;
  pack(state, y);
  ASSERT_EQ(y.size(), 2 * components);
  for (std::size_t k = 0; k < y.size(); ++k)
    EXPECT_EQ(y[k], 1.0 + static_cast<double>(k));
  State back(2);
  unpack(y, back);
  for (const int i : {0, 1}) {
    EXPECT_EQ(back[i].position, state[i].position);
    EXPECT_EQ(back[i].angle, state[i].angle);
    EXPECT_EQ(back[i].velocity, state[i].velocity);
    EXPECT_EQ(back[i].spin, state[i].spin);
  }
}

TEST(MotionPiece, ALookReadsThePolynomial) {
  // Component k: k + 10 s + s (1 - s).
  DenseStep motion;
  for (std::size_t k = 0; k < components; ++k) {
    for (const double c : {static_cast<double>(k), 10.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0})
      motion.coefficients.push_back(c);
  }
  State state(1);
  look_at(motion, 0.5, state);
  const double moved = 5.25;
  EXPECT_EQ(state[0].position, Vec2(0.0 + moved, 1.0 + moved));
  EXPECT_EQ(state[0].angle, 2.0 + moved);
  EXPECT_EQ(state[0].velocity, Vec2(3.0 + moved, 4.0 + moved));
  EXPECT_EQ(state[0].spin, 5.0 + moved);
}

}  // namespace
}  // namespace wuerfel::test
