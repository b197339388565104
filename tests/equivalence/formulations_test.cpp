// The paper's points and the rigid form are one physics: the same motion, step by step, with any
// solver.
#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "core/check.h"
#include "core/scene/scene_parser.h"

namespace wuerfel::test {
namespace {

constexpr double same_acceleration = 1e-10;  // of g

Scene shipped(const std::string& name) {
  std::ifstream file(std::string(SCENES) + "/" + name + ".toml");
  std::stringstream text;
  text << file.rdbuf();
  return parse_scene(text.str(), name);
}

class Formulations : public testing::TestWithParam<const char*> {};

TEST_P(Formulations, GiveTheSameAccelerationsWithEverySolver) {
  const Scene scene = shipped(GetParam());
  const Check expected = check(scene, {});
  for (const Formulation formulation : {Formulation::rigid, Formulation::points}) {
    for (const QpMethod solver : {QpMethod::automatic, QpMethod::ipopt}) {
      const Check answer = check(scene, {.formulation = formulation, .solver = solver});
      EXPECT_EQ(answer.verdict, expected.verdict);
      const double g = scene.gravity.isZero() ? 1.0 : scene.gravity.norm();
      for (std::size_t i = 0; i < scene.cubes.size(); ++i) {
        const Twist& a = answer.accelerations[i];
        const Twist& b = expected.accelerations[i];
        const double side = scene.cubes[i].size.minCoeff();
        const double off = (a.linear - b.linear).norm() + side * std::abs(a.angular - b.angular);
        EXPECT_LE(off, same_acceleration * g)
            << to_string(formulation) << " " << to_string(solver) << " " << scene.cubes[i].name;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped,
                         Formulations,
                         testing::Values("fig1_stack",
                                         "fig1_stack_stands",
                                         "fig2_rods",
                                         "fig3_sides",
                                         "fig6_relative_motion",
                                         "fig7_masses",
                                         "tower",
                                         "wall",
                                         "pyramid",
                                         "overhang_stands",
                                         "overhang_falls",
                                         "tilted_drop",
                                         "ladder",
                                         "demo_frictionless",
                                         "demo",
                                         "jenga",
                                         "rocking_block",
                                         "incline_friction"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace wuerfel::test
