/// What samples of data sets cost beside the physics in them.
///
///     build/release/tests/sweep_benchmark PLAN [REPEATS]
///
/// PLAN is a plan of labels alone (`wuerfel sweep plan assets/sweeps/stacks.toml -o PLAN`); its
/// samples are made anew. Processor time of one thread, least of the repeats (3), of
/// - the bare loop over the library: parse the scene of each case, check it, ask for its labels;
/// - the same as a sweep: manifest, labels and scene as JSON, archives, journals;
/// and the time on the wall of check_many with one thread and with two.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <vector>

#include "app/cli/stopwatch.h"
#include "app/sweep/statics.h"
#include "app/sweep/sweep_run.h"
#include "core/check_many.h"

namespace {

using namespace wuerfel;

/// s of processor time; on the wall.
struct Cost {
  double cpu = std::numeric_limits<double>::infinity();
  double wall = std::numeric_limits<double>::infinity();

  template <class Work>
  void measure(Work work) {
    const Stopwatch watch;
    work();
    cpu = std::min(cpu, watch.cpu());
    wall = std::min(wall, watch.wall());
  }
};

std::vector<Case> cases_of(const Plan& plan) {
  std::vector<Case> cases;
  Manifest manifest(plan);
  while (std::optional<Case> one = manifest.next())
    cases.push_back(std::move(*one));
  return cases;
}

/// Returns how many labels there are, so that nobody leaves them out.
std::size_t label_all(const Sweep& sweep, const std::vector<Case>& cases) {
  std::size_t labels = 0;
  for (const Case& one : cases) {
    const Scene scene = scene_of(sweep, one.values);
    labels += Statics(scene).labels(sweep.labels.check).size();
  }
  return labels;
}

void sweep_anew(const std::string& folder, const StopSignal& stop) {
  std::filesystem::remove_all(std::filesystem::path(folder) / "shards");
  RunChoice choice;
  choice.threads = 1;
  run_plan(Plan(folder), choice, stop, [](long, long) {});
}

void measure(const std::string& folder, int repeats) {
  const StopSignal stop;
  const Plan plan(folder);
  const std::vector<Case> cases = cases_of(plan);
  std::vector<Scene> scenes;
  scenes.reserve(cases.size());
  for (const Case& one : cases)
    scenes.push_back(scene_of(plan.sweep(), one.values));
  Cost bare;
  Cost sweep;
  Cost one_thread;
  Cost two_threads;
  std::size_t labels = 0;
  for (int k = 0; k < repeats; ++k) {
    bare.measure([&] { labels = label_all(plan.sweep(), cases); });
    sweep.measure([&] { sweep_anew(folder, stop); });
    one_thread.measure([&] { check_many(scenes, {}, {1}); });
    two_threads.measure([&] { check_many(scenes, {}, {2}); });
  }
  std::printf("%zu cases, %zu labels\n", cases.size(), labels);
  std::printf("bare loop %.3f s, sweep %.3f s of processor time: %.2f times\n", bare.cpu, sweep.cpu,
              sweep.cpu / bare.cpu);
  std::printf(
      "check_many: 1 thread %.3f s, 2 threads %.3f s on the wall: %.2f times as fast; "
      "processor time %.3f s, %.3f s\n",
      one_thread.wall, two_threads.wall, one_thread.wall / two_threads.wall, one_thread.cpu,
      two_threads.cpu);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2) {
    std::fputs("usage: sweep_benchmark PLAN [REPEATS]\n", stderr);
    return 2;
  }
  measure(argv[1], argc > 2 ? std::max(1, std::atoi(argv[2])) : 3);
} catch (const std::exception& error) {
  std::fprintf(stderr, "sweep_benchmark: %s\n", error.what());
  return 2;
}
