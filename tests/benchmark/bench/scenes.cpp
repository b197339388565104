#include "tests/benchmark/bench/scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "app/cli/choice.h"
#include "core/model/system.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {

namespace {

using Json = nlohmann::json;
using Overrides = std::vector<std::string>;

constexpr std::array motions{"flight", "slide", "tilt", "corner_impact", "edge",
                             "ladder", "rider", "drop", "bullet",        "bullet_free"};
constexpr std::array families{"tower",        "pyramid",    "wall",        "pile",
                              "rubbing_pile", "mass_ratio", "tilt_on_wall"};

std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(fmt::format("cannot read {}", path));
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

Scene read(std::string_view name, const Overrides& overrides = {}) {
  const std::string path = fmt::format(BENCH_SCENES "/{}.toml", name);
  return parse_scene(content(path), path, overrides);
}

// Exact states and times, of 16 digits.
const Json& exact_answers() {
  static const Json answers = Json::parse(content(BENCH_ANSWERS));
  return answers;
}

State state_of(const Json& bodies) {
  State state;
  for (const Json& body : bodies) {
    const auto [x, y, theta, vx, vy, omega] = body.get<std::array<double, 6>>();
    state.push_back({Vec2(x, y), theta, Vec2(vx, vy), omega});
  }
  return state;
}

BenchScene motion(std::string_view name) {
  const Json& answer = exact_answers().at(std::string(name));
  BenchScene bench;
  bench.name = name;
  bench.scene = read(name);
  bench.exact = state_of(answer["bodies"]);
  bench.rests = false;
  if (answer.contains("event")) {
    const Json& event = answer["event"];
    bench.event = KnownEvent{parse_choice<EventKind>("event", event["kind"].get<std::string>()),
                             event["time"], event["look_until"]};
  }
  return bench;
}

BenchScene standing(std::string_view name, Scene scene) {
  BenchScene bench;
  bench.name = name;
  bench.scene = std::move(scene);
  bench.exact = initial_state(bench.scene);
  return bench;
}

// A bin as wide as fits the pile in about as many layers.
Overrides pile_of(long n) {
  const double width = 1.5 * std::ceil(std::sqrt(static_cast<double>(n)));
  const double height = 3.0 * static_cast<double>(n) / width + 2.0;
  const double wall = height + 2.0;
  Overrides overrides{
      fmt::format("pile.pile1.count={}", n),
      fmt::format("pile.pile1.region=[{}, 0.2, {}, {}]", -0.5 * width, 0.5 * width, height)};
  for (const auto& [name, x] :
       {std::pair("left", -0.5 * width - 0.5), std::pair("right", 0.5 * width + 0.5)}) {
    overrides.push_back(fmt::format("fixed.{}.size=[1, {}]", name, wall));
    overrides.push_back(fmt::format("fixed.{}.position=[{}, {}]", name, x, 0.5 * wall));
  }
  return overrides;
}

// What makes the scene of a family one of size `n`.
Overrides size_of(std::string_view family, long n) {
  if (family == "tower") return {fmt::format("tower.tower1.count={}", n)};
  if (family == "pyramid") return {fmt::format("pyramid.pyramid1.rows={}", n)};
  if (family == "wall")
    return {fmt::format("wall.wall1.rows={}", n), fmt::format("wall.wall1.columns={}", n)};
  if (family == "pile") return pile_of(n);
  if (family == "rubbing_pile") {
    Overrides overrides = pile_of(n);
    overrides.emplace_back("material.friction=0.6");
    return overrides;
  }
  return {fmt::format("cube.heavy.mass={}", n)};
}

// The cube of `tilt`, without friction, over the middle of a brick: the others, that rub, stand like fixed ground.
BenchScene tilt_on_wall(const std::string& name, long n) {
  BenchScene bench = motion("tilt");
  Scene scene = read("wall", size_of("wall", n));
  scene.duration = bench.scene.duration;
  for (SceneCube& brick : scene.cubes)
    brick.material.friction = 0.6;
  scene.planes.front().material.friction = 0.6;
  const Vec2 brick = scene.cubes.back().position;
  const Vec2 shift(brick.x(), brick.y() + 0.5 * scene.cubes.back().size.y());
  SceneCube cube = bench.scene.cubes.front();
  cube.position += shift;
  scene.cubes.push_back(std::move(cube));
  State exact = initial_state(scene);
  exact.back() = bench.exact.front();
  exact.back().position += shift;
  bench.name = name;
  bench.scene = std::move(scene);
  bench.exact = std::move(exact);
  bench.event.reset();
  return bench;
}

std::optional<BenchScene> member(const std::string& name) {
  const std::size_t split = name.rfind('_');
  if (split == std::string::npos) return std::nullopt;
  const std::string family = name.substr(0, split);
  if (std::ranges::find(families, family) == families.end()) return std::nullopt;
  const auto n = static_cast<long>(parse_positive("--scenes " + family, name.substr(split + 1)));
  if (family == "tilt_on_wall") return tilt_on_wall(name, n);
  const bool falls = family == "pile" || family == "rubbing_pile";
  Scene scene = read(falls ? "pile" : family, size_of(family, n));
  if (!falls) return standing(name, std::move(scene));
  BenchScene bench;
  bench.name = name;
  bench.scene = std::move(scene);
  bench.rests = false;
  return bench;
}

double smallest_side(const Scene& scene) {
  double side = scene.cubes.front().size.minCoeff();
  for (const SceneCube& cube : scene.cubes)
    side = std::min(side, cube.size.minCoeff());
  return side;
}

// What is not a number is the worst.
void keep_worst(double error, double& worst) {
  if (!(error <= worst)) worst = error;
}

}  // namespace

std::vector<std::string> bench_motions() { return {motions.begin(), motions.end()}; }

std::vector<std::string> bench_stands() {
  return {"tower_10",   "tower_30",    "tower_100", "tower_300",  "tower_1000",
          "tower_3000", "tower_10000", "pyramid_4", "pyramid_13", "pyramid_25",
          "pyramid_40", "pyramid_50",  "wall_10",   "wall_30",    "mass_ratio_1000000",
          "overhang",   "pile_30",     "pile_100"};
}

BenchScene make_bench_scene(std::string_view name) {
  if (std::ranges::find(motions, name) != motions.end()) return motion(name);
  if (name == "overhang") return standing(name, harmonic_overhang(1.0 - 1e-6));
  if (auto scene = member(std::string(name))) return std::move(*scene);
  throw UsageError(fmt::format(
      "--scenes: '{}' is unknown; there is {}, overhang, tower_N, pyramid_N, wall_N, pile_N, "
      "rubbing_pile_N, mass_ratio_N and tilt_on_wall_N",
      name, fmt::join(motions, ", ")));
}

Scene harmonic_overhang(double scale) {
  constexpr int count = 10;
  Overrides overrides{fmt::format("cube.c{}.offset={}", count, 4.5 + scale / (2.0 * count))};
  for (int k = count - 1; k >= 1; --k)
    overrides.push_back(fmt::format("cube.c{}.offset={}", k, scale / (2.0 * k)));
  return read("overhang", overrides);
}

double place_error(const Scene& scene, const State& actual, const State& exact) {
  const double side = smallest_side(scene);
  double worst = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const Vec2 place = actual[i].position - exact[i].position;
    keep_worst(place.cwiseAbs().maxCoeff() / side, worst);
    keep_worst(std::abs(actual[i].angle - exact[i].angle), worst);
  }
  return worst;
}

double state_error(const Scene& scene, const State& actual, const State& exact) {
  double speed = std::sqrt(scene.gravity.norm() * smallest_side(scene));
  if (speed == 0.0) {
    for (const SceneCube& cube : scene.cubes)
      speed = std::max(speed, cube.velocity.norm());
  }
  const double rate = speed / smallest_side(scene);  // 1/s
  double worst = place_error(scene, actual, exact);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const Vec2 off = actual[i].velocity - exact[i].velocity;
    keep_worst(off.cwiseAbs().maxCoeff() / speed, worst);
    keep_worst(std::abs(actual[i].spin - exact[i].spin) / rate, worst);
  }
  return worst;
}

}  // namespace wuerfel
