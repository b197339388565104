// Motions with exact answers: states and event times, at the default tolerance and at a tight one.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/time/simulation.h"
#include "tests/support/reference_case.h"

namespace wuerfel::test {
namespace {

/// States at events are one-sided: they are looked at this much later or earlier and moved back.
constexpr double beside_event = 2e-8;

struct Goal {
  double tolerance;   ///< what the simulation is asked for
  double state;       ///< of the cube's size, and of sqrt(g size)
  double event_time;  ///< s
};

/// tip_corner_square_tiny amplifies errors some four hundred times.
Goal goal_for(const std::string& name, double tolerance) {
  const bool amplifies = name == "tip_corner_square_tiny";
  if (tolerance == 1e-8) return amplifies ? Goal{1e-8, 2e-7, 5e-8} : Goal{1e-8, 1e-7, 1e-8};
  return amplifies ? Goal{1e-11, 2e-9, 5e-10} : Goal{1e-11, 1e-9, 1e-10};
}

class Trajectory : public testing::TestWithParam<std::tuple<std::string, double>> {
 protected:
  Trajectory()
      : reference(read_reference_case(std::get<0>(GetParam()))),
        goal(goal_for(std::get<0>(GetParam()), std::get<1>(GetParam()))) {
    settings.tolerance = goal.tolerance;
    for (const SceneCube& cube : reference.scene.cubes)
      size = std::max(size, cube.size.maxCoeff());
    for (const auto& expected : reference.data["expected"]) {
      if (is_event(expected)) event_times.push_back(expected["value"].get<double>());
    }
  }

  /// A peak of a motion is no event.
  static bool is_event(const nlohmann::json& expected) {
    return expected["type"] == "event_time"
           && expected["id"].get<std::string>().find("peak") == std::string::npos;
  }

  void compare(Simulation& simulation, const nlohmann::json& expected) const {
    const double t = expected["t"].get<double>();
    const bool at_event =
        std::ranges::any_of(event_times, [&](double event) { return std::abs(event - t) < 1e-9; });
    const std::string side = expected.value("side", "");
    const bool before = side == "before" || expected["id"].get<std::string>().ends_with("before");
    if (at_event && side != "after" && !before) return;
    const double later = !at_event ? 0.0 : before ? -beside_event : beside_event;
    simulation.advance_to(t + later);
    const BodyState& s =
        simulation.states()[static_cast<std::size_t>(reference.cube(expected["body"]))];
    const auto& value = expected["value"];
    const double slack = at_event ? 3.0 : 1.0;
    const double speed = std::sqrt(9.81 * size);
    const double bent = std::abs(later) * 20.0 * 9.81;
    const auto near = [&](const char* key, double got, double unit, double allowance) {
      EXPECT_NEAR(got, value[key].get<double>(), slack * goal.state * unit + allowance)
          << expected["id"] << " " << key << " at " << t;
    };
    near("x", s.position.x() - later * s.velocity.x(), size, bent * std::abs(later));
    near("y", s.position.y() - later * s.velocity.y(), size, bent * std::abs(later));
    near("theta", s.angle - later * s.spin, 1.0, bent * std::abs(later) / size);
    near("vx", s.velocity.x(), speed, bent);
    near("vy", s.velocity.y(), speed, bent);
    near("omega", s.spin, speed / size, bent / size);
  }

  ReferenceCase reference;
  Goal goal;
  MotionSettings settings;
  double size = 0.0;
  std::vector<double> event_times;
};

TEST_P(Trajectory, StatesAreExactToTheTolerance) {
  std::vector<const nlohmann::json*> states;
  for (const auto& expected : reference.data["expected"]) {
    if (expected["type"] == "state") states.push_back(&expected);
  }
  // Simulations only go on.
  std::ranges::stable_sort(states, {},
                           [](const auto* e) { return (*e)["t"].template get<double>(); });
  for (const auto* expected : states) {
    Simulation simulation(reference.scene, settings);
    compare(simulation, *expected);
    EXPECT_LE(simulation.audit().max_penetration, 1e-9 * size);
    EXPECT_EQ(simulation.audit().missed_solves, 0);
  }
}

TEST_P(Trajectory, EventsHappenInTime) {
  Simulation simulation(reference.scene, settings);
  simulation.advance_to(reference.data["t_end"].get<double>() + 1e-6);
  for (const double expected : event_times) {
    double off = 1e9;
    for (const Event& event : simulation.events())
      off = std::min(off, std::abs(event.t - expected));
    EXPECT_LE(off, goal.event_time) << "event at " << expected;
  }
  EXPECT_LE(simulation.events().size(), 100 + 40 * event_times.size());
}

TEST_P(Trajectory, EnergyIsLostInImpactsOnly) {
  Simulation simulation(reference.scene, settings);
  simulation.advance_to(reference.data["t_end"].get<double>());
  const Audit audit = simulation.audit();
  double scale = 0.0;
  for (const SceneCube& cube : reference.scene.cubes)
    scale += cube.mass * 9.81 * size;
  EXPECT_LE(std::abs(audit.drift()), 10.0 * settings.tolerance * scale);
  EXPECT_GE(audit.impact_loss, -1e-12 * scale);
  EXPECT_EQ(audit.unresolved, 0);
}

INSTANTIATE_TEST_SUITE_P(Reference,
                         Trajectory,
                         testing::Combine(testing::ValuesIn(reference_case_names("trajectory")),
                                          testing::Values(1e-8, 1e-11)),
                         [](const auto& test) {
                           return test_name(std::get<0>(test.param))
                                  + (std::get<1>(test.param) == 1e-8 ? "_1em8" : "_1em11");
                         });

}  // namespace
}  // namespace wuerfel::test
