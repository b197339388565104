// Margins of 200 random stacks against an exact rational simplex: tests/data/statics/random_stacks.py.
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/statics/margins.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

constexpr double exact_number = 1e-9;

Scene scene_of(const nlohmann::json& stack) {
  std::vector<SceneCube> cubes;
  for (const auto& brick : stack.at("bricks")) {
    const auto number = [&](int k) { return brick[k].get<double>(); };
    SceneCube c = sized_cube("b" + std::to_string(cubes.size()), Vec2(number(0), number(1)),
                             Vec2(number(2), number(3)));
    c.mass = number(4);
    cubes.push_back(c);
  }
  return on_floor(cubes);
}

// `unit` is what an error is measured by, beside the end itself.
void expect_range(const LoadRange& found, const nlohmann::json& expected, double unit) {
  ASSERT_EQ(is_empty(found), expected.is_null());
  if (expected.is_null()) return;
  const auto end = [&](double value, const nlohmann::json& exactly, double limit) {
    if (exactly.is_null()) {
      EXPECT_EQ(value, limit);
      return;
    }
    const double want = exactly;
    EXPECT_NEAR(value, want, exact_number * std::max(unit, std::abs(want)));
  };
  end(found.low, expected[0], -unbounded);
  end(found.high, expected[1], unbounded);
}

TEST(RandomStacks, HaveTheMarginsOfAnExactSimplex) {
  std::ifstream file(std::string(TEST_DATA) + "/statics/random_stacks.json");
  const nlohmann::json stacks = nlohmann::json::parse(file);
  ASSERT_EQ(stacks.size(), 200U);
  for (std::size_t k = 0; k < stacks.size(); ++k) {
    SCOPED_TRACE(k);
    const StillScene still = stopped_scene(scene_of(stacks[k]), {});
    const int body = stacks[k].at("body");
    const BodyMargin margin =
        find_margins(still, {}, {false, true, true, false, {body}}).bodies.front();
    expect_range(margin.shift, stacks[k].at("shift"), 1e-3);
    expect_range(margin.load, stacks[k].at("load"), still.weight(body));
    expect_range(tilt_range(still, Sliding::none), stacks[k].at("tilt"), 1e-3);
  }
}

}  // namespace
}  // namespace wuerfel::test
