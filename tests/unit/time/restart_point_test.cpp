// Restart points: a motion that is taken up again has the bits of one in one go.
#include "core/time/restart_point.h"

#include <bit>

#include <gtest/gtest.h>

#include "core/scene/scene_parser.h"
#include "core/time/simulation.h"

namespace wuerfel::test {
namespace {

constexpr const char* crowd = R"(
duration = 2.0
[[plane]]
name = "floor"
[[fixed]]
size = [0.2, 6.0]
position = [-2.0, 3.0]
[[fixed]]
size = [0.2, 6.0]
position = [2.0, 3.0]
[[pile]]
count = 30
region = [-1.7, 0.3, 1.7, 5.0]
size = 0.3
seed = 3
)";

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same_bits(const State& a, const State& b) {
  return std::ranges::equal(a, b, [](const BodyState& s, const BodyState& t) {
    return same_bits(s.position.x(), t.position.x()) && same_bits(s.position.y(), t.position.y())
           && same_bits(s.angle, t.angle) && same_bits(s.velocity.x(), t.velocity.x())
           && same_bits(s.velocity.y(), t.velocity.y()) && same_bits(s.spin, t.spin);
  });
}

struct Case {
  Integrator integrator;
  double until;
};

class Restart : public testing::TestWithParam<Case> {
 protected:
  Scene scene = parse_scene(crowd, "crowd");
  MotionSettings settings() const {
    MotionSettings settings{.integrator = GetParam().integrator, .step = 0.0005};
    // Short steps make enough work for a restart in a short run.
    if (settings.integrator == Integrator::automatic) settings.tolerance = 1e-13;
    return settings;
  }
};

TEST_P(Restart, GoesOnToTheSameBits) {
  const double until = GetParam().until;
  std::vector<std::string> points;
  Simulation whole(scene, settings());
  whole.set_restart_listener([&points](std::string point) { points.push_back(std::move(point)); });
  whole.advance_to(until);
  ASSERT_FALSE(points.empty());
  Simulation resumed(scene, settings(), points.front());
  EXPECT_GT(resumed.time(), 0.0);
  resumed.advance_to(0.5 * (resumed.time() + until));
  resumed.advance_to(until);
  EXPECT_TRUE(same_bits(resumed.states(), whole.states()));
  EXPECT_EQ(resumed.state_hash(), whole.state_hash());
  EXPECT_EQ(resumed.events().size(), whole.events().size());
  EXPECT_TRUE(same_bits(resumed.audit().drift(), whole.audit().drift()));
  EXPECT_EQ(resumed.cost().steps, whole.cost().steps);
}

TEST_P(Restart, ListenersChangeNothing) {
  Simulation alone(scene, settings());
  alone.advance_to(GetParam().until);
  Simulation heard(scene, settings());
  heard.set_restart_listener([](const std::string&) {});
  for (int k = 1; k <= 7; ++k)
    heard.advance_to(GetParam().until * k / 7);
  EXPECT_EQ(alone.state_hash(), heard.state_hash());
}

INSTANTIATE_TEST_SUITE_P(Integrators,
                         Restart,
                         testing::Values(Case{Integrator::automatic, 12.0},
                                         Case{Integrator::rattle, 1.0},
                                         Case{Integrator::moreau, 1.0}),
                         [](const auto& test) {
                           return std::string(to_string(test.param.integrator));
                         });

TEST(RestartPoints, AreRefusedWhereTheyAreCutOrOfAnotherScene) {
  RestartPoint point;
  point.state.resize(3);
  point.resting.resize(3);
  point.stepping.resize(3);
  point.book.events.push_back({1.0, EventKind::impact, "a", "b", Vec2(1.0, 2.0), 3.0});
  const std::string bytes = to_bytes(point);
  EXPECT_EQ(restart_point_of(bytes, 3).book.events.front().on, "a");
  EXPECT_THROW(restart_point_of(bytes, 4), RestartError);
  EXPECT_THROW(restart_point_of(bytes + "x", 3), RestartError);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW(restart_point_of(std::string_view(bytes).substr(0, size), 3), RestartError);
}

}  // namespace
}  // namespace wuerfel::test
