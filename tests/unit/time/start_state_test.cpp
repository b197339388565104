// Scenes that no motion can start from.
#include "core/time/start_state.h"

#include <gtest/gtest.h>

#include "core/scene/scene_parser.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

/// The message of the error that a scene is refused with; empty: it is not.
template <typename Start>
std::string message_of(Start&& start) {
  try {
    start();
  } catch (const SceneError& error) {
    return error.what();
  }
  return {};
}

TEST(StartState, BodiesThatOverlapAreNamed) {
  const auto message = [](double height) {
    return message_of([&] {
      EXPECT_EQ(start_state(on_floor({cube("a", {0.0, height})})).size(), 1U);
    });
  };
  EXPECT_EQ(message(0.5), "");
  EXPECT_EQ(message(0.5 - 0.9e-9), "") << "that is touching";
  EXPECT_NE(message(0.4).find("\"a\" and \"floor\" overlap by 0.1 m"), std::string::npos)
      << message(0.4);
}

TEST(StartState, RodsThatContradictEachOtherAreNamed) {
  // A point between two fixed places in one line, that flies across: no acceleration keeps both lengths.
  //   o---*---o
  const auto message = [](double speed) {
    Scene scene;
    scene.gravity = Vec2::Zero();
    scene.points.push_back({"bead", 1.0, Vec2::Zero(), {0.0, speed}, {}});
    scene.rods.push_back({"left", {"bead", Vec2::Zero()}, {"", {-1.0, 0.0}}, 1.0});
    scene.rods.push_back({"right", {"bead", Vec2::Zero()}, {"", {1.0, 0.0}}, 1.0});
    const Mechanism m(scene);
    return message_of(
        [&] { require_consistent_rods(m.system, m.state, [] { return std::vector<Twist>(1); }); });
  };
  EXPECT_EQ(message(0.0), "");
  EXPECT_EQ(message(1.0),
            "rods contradict each other: no acceleration keeps the lengths of \"left\", \"right\" "
            "at once");
}

}  // namespace
}  // namespace wuerfel::test
