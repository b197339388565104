/// Runs peers and ourselves on the same scenes in one process, and compares.
///
///     build/peers/tests/benchmark/peers/peers [--csv FILE] [--plot FOLDER] [--budget S]
///         [--scenes A,B,..]
///
/// Prints Markdown: all rows, ratios, and the harmonic overhang.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string_view>

#include <fmt/core.h>

#include "app/cli/argument.h"
#include "app/cli/exit_code.h"
#include "app/cli/progress.h"
#include "app/output/text_output.h"
#include "core/time/simulation.h"
#include "tests/benchmark/bench/measure.h"
#include "tests/benchmark/bench/plot.h"
#include "tests/benchmark/peers/deepest_overlap.h"
#include "tests/benchmark/peers/measure_peer.h"
#include "tests/benchmark/peers/ratios.h"

namespace {

using namespace wuerfel;
using namespace wuerfel::bench;

struct Options {
  std::vector<std::string> scenes{"flight",
                                  "slide",
                                  "tilt",
                                  "corner_impact",
                                  "bullet",
                                  "bullet_free",
                                  "tower_10",
                                  "tower_30",
                                  "tower_100",
                                  "mass_ratio_100",
                                  "mass_ratio_10000",
                                  "mass_ratio_1000000",
                                  "pyramid_20",
                                  "pyramid_40",
                                  "wall_30",
                                  "pile_30",
                                  "rubbing_pile_30",
                                  "rubbing_pile_100"};
  std::string csv;
  std::string plot;
  double budget = 0.1;  // s
};

Options parse(int argc, char** argv) {
  Options options;
  for (int k = 1; k < argc; k += 2) {
    const std::string_view key = argv[k];
    if (k + 1 == argc) throw UsageError(fmt::format("{} needs a value", key));
    const std::string value = argv[k + 1];
    if (key == "--scenes") {
      options.scenes = split_list(value);
    } else if (key == "--csv") {
      options.csv = value;
    } else if (key == "--plot") {
      options.plot = value;
    } else if (key == "--budget") {
      options.budget = parse_time(key, value);
    } else {
      throw UsageError(fmt::format("{} is unknown", key));
    }
  }
  return options;
}

std::vector<Peer> all_peers() {
  std::vector<Peer> peers = box2d_peers();
  for (const auto& more : {chipmunk_peers(), mujoco_peers()})
    peers.insert(peers.end(), more.begin(), more.end());
  return peers;
}

std::vector<double> steps_for(const BenchScene& scene) {
  const std::size_t cubes = scene.scene.cubes.size();
  std::vector<double> steps{1.0 / 60, 1.0 / 240};
  if (!scene.exact.empty() && cubes <= 30) steps.push_back(1.0 / 960);
  if (!scene.exact.empty() && cubes <= 3) steps.push_back(1.0 / 3840);
  if (cubes > 200) steps.pop_back();
  return steps;
}

// Our own row, its overlap measured as that of the peers, at 60 looks a second.
BenchRow measure_ours(const BenchScene& scene, const MotionSettings& settings, double budget) {
  BenchRow row = measure(scene, settings, budget);
  Simulation simulation(scene.scene, settings);
  for (int k = 1; k <= static_cast<int>(60.0 * scene.scene.duration); ++k) {
    simulation.advance_to(k / 60.0);
    row.overlap = std::max(*row.overlap, deepest_overlap(scene.scene, simulation.states()));
  }
  return row;
}

std::vector<BenchRow> measure_scene(const std::string& name, double budget) {
  const BenchScene scene = make_bench_scene(name);
  std::vector<BenchRow> rows;
  for (const MotionSettings& settings : bench_settings({}, scene))
    rows.push_back(measure_ours(scene, settings, budget));
  for (const Peer& peer : all_peers()) {
    if (scene.scene.cubes.size() > peer.most_cubes) continue;
    if (!peer.rubs && scene.scene.cubes.front().material.friction > 0.0) continue;
    for (const double step : steps_for(scene))
      rows.push_back(measure_peer(peer, scene, step, budget));
  }
  return rows;
}

// The smallest distance from the limit that is still judged right, whatever larger ones are.
template <class Stands>
std::string smallest_right(double side, Stands&& stands) {
  constexpr std::array distances{0.3,  0.2,  0.1,  5e-2, 2e-2, 1e-2,
                                 5e-3, 2e-3, 1e-3, 1e-4, 1e-5, 1e-6};
  std::string right = "none";
  for (const double distance : distances) {
    if (stands(1.0 + side * distance) == (side < 0.0)) right = fmt::format("{:.0e}", distance);
  }
  return right;
}

void print_overhangs() {
  fmt::print(
      "\n| harmonic overhang of 10 | step | stands from 1 - | falls from 1 + "
      "|\n|---|---|---|---|\n");
  const auto ours = [](double scale) { return overhang_stands(scale); };
  fmt::print("| wuerfel | | {} | {} |\n", smallest_right(-1.0, ours), smallest_right(1.0, ours));
  for (const Peer& peer : all_peers()) {
    if (peer.most_cubes < 10) continue;
    for (const double step : {1.0 / 60, 1.0 / 240}) {
      const auto theirs = [&](double scale) { return overhang_stands(peer, scale, step); };
      fmt::print("| {} {} | 1/{:.0f} s | {} | {} |\n", peer.engine, peer.method, 1.0 / step,
                 smallest_right(-1.0, theirs), smallest_right(1.0, theirs));
      std::fflush(stdout);
    }
  }
}

void run(const Options& options) {
  Progress progress(Progress::style_for_stderr(false), "peers",
                    static_cast<double>(options.scenes.size()), "scenes");
  std::vector<BenchRow> rows;
  double done = 0.0;
  for (const std::string& name : options.scenes) {
    for (BenchRow& row : measure_scene(name, options.budget))
      rows.push_back(std::move(row));
    progress.reached(++done);
  }
  progress.end();
  const BenchMachine machine = this_machine();
  if (!options.csv.empty()) write_text(options.csv, bench_csv(rows, machine));
  fmt::print("{}\n{}", bench_table(rows, machine), ratio_table(rows));
  std::fflush(stdout);
  if (!options.plot.empty()) draw_bench_plots(rows, machine, options.plot);
  print_overhangs();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(parse(argc, argv));
  } catch (const std::exception& error) {
    fmt::print(stderr, "peers: {}\n", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
