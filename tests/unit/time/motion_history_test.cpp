// What is known of a motion, until it is forgotten. Also track_test.cpp.
#include "core/time/motion_history.h"

#include <gtest/gtest.h>

#include "core/scene/scene_parser.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

/// A cube that rests at x = 0 from 1 s on and at x = 5 from 2 s on.
class MovedRest : public testing::Test {
 protected:
  MovedRest() {
    for (const double x : {0.0, 5.0}) {
      MotionPiece piece;
      piece.kind = MotionPiece::Kind::rest;
      piece.begin = 1.0 + x / 5.0;
      piece.start = mechanism.state;
      piece.start[0].position.x() = x;
      history.pieces().push_back(piece);
    }
    end = history.pieces().back().start;
    end[0].position.x() = 7.0;
  }
  double x_at(double t) { return history.at(t, end, events)[0].position.x(); }

  Mechanism mechanism{on_floor({cube("a", {0.0, 0.5})})};
  EventMotion events{mechanism.system, {}};
  MotionHistory history{mechanism.system, {}};
  State end;
};

TEST_F(MovedRest, PiecesLastUntilTheNextOneBegins) {
  EXPECT_EQ(x_at(1.0), 0.0);
  EXPECT_EQ(x_at(1.999), 0.0);
  EXPECT_EQ(x_at(2.0), 5.0);
  EXPECT_EQ(history.piece_at(9.0), &history.pieces().back());
}

TEST_F(MovedRest, OfWhatIsNotKnownTheEndIsTold) {
  EXPECT_EQ(history.piece_at(0.5), nullptr);
  EXPECT_EQ(x_at(0.5), 7.0);
  history.forget_before(2.5);
  EXPECT_EQ(history.pieces().size(), 1);
  EXPECT_EQ(x_at(1.5), 7.0);
}

TEST_F(MovedRest, SweepsWhatLastsBeyondATime) {
  const double radius = mechanism.system.bodies[0].radius();
  const auto swept_since = [&](double t) {
    std::vector<BoundingBox> bounds(1, {end[0].position, end[0].position});
    history.sweep(t, 3.0, end, bounds);
    EXPECT_EQ(bounds[0].high.x(), 7.0 + radius);
    return bounds[0].low.x();
  };
  EXPECT_EQ(swept_since(1.5), -radius);
  EXPECT_EQ(swept_since(2.5), 5.0 - radius);
}

}  // namespace
}  // namespace wuerfel::test
