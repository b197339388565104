#include "app/bench_scenes.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "app/argument.h"
#include "app/exit_code.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {

namespace {

constexpr double standing_time = 10.0;  // s
constexpr double pile_time = 2.0;       // s

constexpr std::string_view floor_text = "version = 1\n[[plane]]\nname = \"floor\"\n";

struct Motion {
  std::string_view name;
  std::string_view meaning;
  std::string_view text;
  double end;
  std::vector<BodyState> exact;
  std::optional<KnownEvent> event;
};

// States and times to 16 digits: closed forms, or the energy integral by quadrature with 30 digits,
// or (edge, rider, ladder) Newton-Euler equations by extrapolation of order 22 with 34 digits.
// tests/data/reference has edge (edge_tip_square_d0.05), ladder (ladder_thin), rider
// (edge_rider_plank2) and drop (drop_tilted_square_spin) with more digits and the way to each
// number.
std::vector<Motion> motions() {
  return {
      {"flight",
       "free flight, 1 s",
       "version = 1\n[[cube]]\nposition = [0, 10]\nvelocity = [3, 4]\nspin = 2\n",
       1.0,
       {{{3.0, 9.095}, 2.0, {3.0, -5.81}, 2.0}},
       {}},
      {"slide",
       "sliding down 20 degrees, 2 s",
       "version = 1\n[[plane]]\nnormal = [0.342020143325668733, 0.939692620785908384]\n"
       "[[cube]]\nposition = [0.171010071662834367, 0.469846310392954192]\n"
       "angle = -0.349065850398865915\n",
       2.0,
       {{{6.476756522687785, -1.825257702609871},
         -0.3490658503988659,
         {6.305746451024951, -2.295104013002825},
         0.0}},
       {}},
      {"tilt",
       "tilting about a corner, 0.3 s",
       "version = 1\n[[plane]]\n[[cube]]\nposition = [0, 0.696364240320018943]\n"
       "angle = 0.610865238198015352\n",
       0.3,
       {{{0.0, 0.6179489898060420},
         0.2777945093453327,
         {0.0, -0.7988627119161305},
         -2.324210295039026}},
       KnownEvent{EventKind::impact, 0.4030184473420851, 0.41}},
      {"corner_impact",
       "fall of 1 m on a corner, 0.5 s",
       "version = 1\n[[plane]]\n[[cube]]\nposition = [0, 1.66446302438867470]\n"
       "angle = 0.436332312998582394\n",
       0.5,
       {{{0.0, 0.5971575506808653},
         0.2056929055866041,
         {0.0, -1.626195041785110},
         -4.757770841330906}},
       KnownEvent{EventKind::impact, 0.4515236409857309, 0.46}},
      {"edge",
       "tipping over an edge and letting go",
       "version = 1\n[[fixed]]\nsize = [10, 1]\nposition = [-5, -0.5]\n[[cube]]\n"
       "position = [0.05, 0.5]\n",
       1.08,
       {{{0.719025914765872, -0.1097895617298189},
         -0.9229753775134625,
         {1.405080225834735, -3.072159822561046},
         -1.819320947082629}},
       KnownEvent{EventKind::release, 0.9796018096524735, 1.08}},
      {"ladder",
       "ladder sliding down a wall, 0.9 s",
       "version = 1\n[[plane]]\nname = \"floor\"\n[[plane]]\nname = \"wall\"\nnormal = [1, 0]\n"
       "[[cube]]\nsize = [2, 0.01]\nposition = [0.3670179499065097, 0.9338508747396097]\n"
       "angle = -1.2\n",
       0.9,
       {{{1.1027801123207976 + 1.3205275084083676 * (0.9 - 0.8172543022908063), 0.005},
         0.0,
         {1.3205275084083676, 0.0},
         0.0}},
       KnownEvent{EventKind::release, 0.5767586336850875, 0.7}},
      {"rider",
       "two squares on a tilting plank",
       "version = 1\n[[fixed]]\nsize = [10, 1]\nposition = [-5, -0.5]\n"
       "[[cube]]\nname = \"plank\"\nsize = [3, 0.25]\nmass = 5\n"
       "position = [0.3188536397017551, 0.06290752299163684]\nangle = -0.2\n"
       "velocity = [0.1294604192799426, -0.1792937529303837]\nspin = -0.5\n"
       "[[cube]]\nsize = 0.5\nposition = [-0.19468530795484187, 0.5496340881591392]\nangle = -0.2\n"
       "velocity = [0.37282370186369373, 0.07747572089791482]\nspin = -0.5\n"
       "[[cube]]\nsize = 0.4\nmass = 2\nposition = [0.7754478033466466, 0.3019614284720159]\n"
       "angle = -0.2\nvelocity = [0.4450006875883804, -0.44732470091184173]\nspin = -0.5\n",
       0.32678,
       {{{0.46553726827633407, -0.15709969969884893},
         -0.5826980428157185,
         {0.7777428260210176, -1.4826060884467946},
         -1.7046190275922377},
        {{0.07330419509644172, 0.5505062398919099},
         -0.5826980428157185,
         {1.338295767980851, -0.38849736650974875},
         -1.7046190275922377},
        {{0.9924107277284171, -0.1150954745426064},
         -0.5826980428157185,
         {0.8597330786324147, -2.3875713240478817},
         -1.7046190275922377}},
       KnownEvent{EventKind::release, 0.36309300676584894, 0.365}},
      {"drop",
       "flight, corner impact, turning, 0.81 s",
       "version = 1\n[[plane]]\n[[cube]]\nmass = 2\nposition = [0, 2]\nangle = 1\n"
       "velocity = [-0.2, 1]\nspin = -0.4\n",
       0.806036,
       {{{-0.1612072, 0.6738602474742321},
         0.4775318500318353,
         {-0.2, -0.4341668398390738},
         -2.026244315305143}},
       KnownEvent{EventKind::impact, 0.9866197966190617, 1.0}},
      {"bullet",
       "200 m/s against a fixed wall of 2 cm",
       "version = 1\ngravity = [0, 0]\n[[fixed]]\nsize = [0.02, 2]\nposition = [0, 0]\n"
       "[[cube]]\nsize = 0.1\nposition = [-5, 0]\nvelocity = [200, 0]\n",
       0.1,
       {{{-0.06, 0.0}, 0.0, {0.0, 0.0}, 0.0}},
       KnownEvent{EventKind::impact, 4.94 / 200.0, 0.03}},
      {"bullet_free",
       "200 m/s against a free wall of 2 cm and 100 kg",
       "version = 1\ngravity = [0, 0]\n[[cube]]\nsize = 0.1\nposition = [-5, 0]\n"
       "velocity = [200, 0]\n[[cube]]\nsize = [0.02, 2]\nposition = [0, 0]\nmass = 100\n",
       0.1,
       {{{-0.06 + 200.0 / 101.0 * (0.1 - 4.94 / 200.0), 0.0}, 0.0, {200.0 / 101.0, 0.0}, 0.0},
        {{200.0 / 101.0 * (0.1 - 4.94 / 200.0), 0.0}, 0.0, {200.0 / 101.0, 0.0}, 0.0}},
       KnownEvent{EventKind::impact, 4.94 / 200.0, 0.03}},
  };
}

BenchScene standing(std::string name, std::string meaning, Scene scene) {
  BenchScene bench{std::move(name), std::move(meaning), std::move(scene), standing_time, {}, true,
                   std::nullopt};
  bench.exact = start_state(bench.scene);
  return bench;
}

Scene parse(const std::string& text) { return parse_scene(text, "bench"); }

std::string repeat_count(std::string_view generator, long n) {
  return fmt::format("{}[[{}]]\non = \"floor\"\n{} = {}\n", floor_text, generator,
                     generator == "tower" ? "count" : "rows", n);
}

// A bin as wide as fits the pile in about as many layers.
BenchScene pile(const std::string& name, long n) {
  const double width = 1.5 * std::ceil(std::sqrt(static_cast<double>(n)));
  const double height = 3.0 * static_cast<double>(n) / width + 2.0;
  const double wall = height + 2.0;
  BenchScene bench;
  bench.name = name;
  bench.meaning = fmt::format("{} squares dropped in a bin, {} s", n, pile_time);
  bench.scene = parse(
      fmt::format("{}[[fixed]]\nsize = [1, {}]\nposition = [{}, {}]\n[[fixed]]\nsize = [1, {}]\n"
                  "position = [{}, {}]\n[[pile]]\ncount = {}\nregion = [{}, 0.2, {}, {}]\n",
                  floor_text, wall, -0.5 * width - 0.5, 0.5 * wall, wall, 0.5 * width + 0.5,
                  0.5 * wall, n, -0.5 * width, 0.5 * width, height));
  bench.end = pile_time;
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

std::optional<BenchScene> make_family(const std::string& name) {
  const std::size_t split = name.rfind('_');
  if (split == std::string::npos) return std::nullopt;
  const std::string family = name.substr(0, split);
  if (family != "tower" && family != "pyramid" && family != "wall" && family != "pile"
      && family != "mass_ratio")
    return std::nullopt;
  const auto n = static_cast<long>(parse_positive("--scenes " + family, name.substr(split + 1)));
  if (family == "pile") return pile(name, n);
  if (family == "wall")
    return standing(
        name, fmt::format("wall {0} x {0}, 10 s", n),
        parse(fmt::format("{}[[wall]]\non = \"floor\"\nrows = {}\ncolumns = {}\nsize = [1, 0.6]\n",
                          floor_text, n, n)));
  if (family == "mass_ratio")
    return standing(name, fmt::format("{} kg on 1 kg, 10 s", n),
                    parse(fmt::format("{}[[cube]]\nname = \"light\"\non = \"floor\"\n[[cube]]\n"
                                      "on = \"light\"\nmass = {}\n",
                                      floor_text, n)));
  return standing(
      name,
      family == "tower" ? fmt::format("tower of {}, 10 s", n) : fmt::format("pyramid, {} rows", n),
      parse(repeat_count(family, n)));
}

}  // namespace

std::vector<std::string> bench_motions() {
  std::vector<std::string> names;
  for (const Motion& motion : motions())
    names.emplace_back(motion.name);
  return names;
}

std::vector<std::string> bench_stands() {
  return {"tower_10",   "tower_30",    "tower_100", "tower_300",  "tower_1000",
          "tower_3000", "tower_10000", "pyramid_4", "pyramid_13", "pyramid_25",
          "pyramid_40", "pyramid_50",  "wall_10",   "wall_30",    "mass_ratio_1000000",
          "overhang",   "pile_30",     "pile_100"};
}

BenchScene make_bench_scene(std::string_view name) {
  const std::string text(name);
  for (Motion& motion : motions()) {
    if (motion.name == name)
      return {text,        std::string(motion.meaning), parse(std::string(motion.text)),
              motion.end,  std::move(motion.exact),     false,
              motion.event};
  }
  if (name == "overhang")
    return standing(text, "harmonic overhang of 10, 1e-6 inside", harmonic_overhang(1.0 - 1e-6));
  if (auto scene = make_family(text)) return std::move(*scene);
  throw UsageError(fmt::format(
      "--scenes: '{}' is unknown; there is {}, overhang, tower_N, pyramid_N, wall_N, pile_N and "
      "mass_ratio_N",
      name, fmt::join(bench_motions(), ", ")));
}

Scene harmonic_overhang(double scale) {
  constexpr int count = 10;
  std::string text = fmt::format(
      "version = 1\n[[fixed]]\nname = \"table\"\nsize = [10, 1]\nposition = [-5, -0.5]\n[[cube]]\n"
      "name = \"c{}\"\non = \"table\"\noffset = {}\n",
      count, 4.5 + scale / (2.0 * count));
  for (int k = count - 1; k >= 1; --k)
    text += fmt::format("[[cube]]\nname = \"c{}\"\non = \"c{}\"\noffset = {}\n", k, k + 1,
                        scale / (2.0 * k));
  return parse(text);
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
  if (speed == 0.0)
    for (const SceneCube& cube : scene.cubes)
      speed = std::max(speed, cube.velocity.norm());
  const double rate = speed / smallest_side(scene);  // 1/s
  double worst = place_error(scene, actual, exact);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const Vec2 off = actual[i].velocity - exact[i].velocity;
    keep_worst(off.cwiseAbs().maxCoeff() / speed, worst);
    keep_worst(std::abs(actual[i].spin - exact[i].spin) / rate, worst);
  }
  return worst;
}

double state_energy(const Scene& scene, const State& state) {
  double sum = 0.0;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const SceneCube& cube = scene.cubes[i];
    const double inertia = cube.mass * cube.size.squaredNorm() / 12.0;
    sum += 0.5 * cube.mass * state[i].velocity.squaredNorm()
           + 0.5 * inertia * state[i].spin * state[i].spin
           - cube.mass * scene.gravity.dot(state[i].position);
  }
  return sum;
}

State start_state(const Scene& scene) {
  State state;
  state.reserve(scene.cubes.size());
  for (const SceneCube& cube : scene.cubes)
    state.push_back({cube.position, cube.angle, cube.velocity, cube.spin});
  return state;
}

}  // namespace wuerfel
