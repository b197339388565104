#include <cstdio>

#include <fmt/core.h>

#include "app/bench_measure.h"
#include "app/bench_plot.h"
#include "app/commands.h"
#include "app/progress.h"
#include "app/stop_signal.h"
#include "app/text_output.h"

namespace wuerfel {

namespace {

struct Job {
  std::size_t scene = 0;
  MotionSettings settings;
};

std::vector<BenchScene> chosen_scenes(std::vector<std::string> names) {
  if (names.empty()) {
    names = bench_motions();
    for (std::string& stand : bench_stands())
      names.push_back(std::move(stand));
  }
  std::vector<BenchScene> scenes;
  scenes.reserve(names.size());
  for (const std::string& name : names)
    scenes.push_back(make_bench_scene(name));
  return scenes;
}

std::vector<Job> plan(const std::vector<BenchScene>& scenes,
                      const std::vector<std::string>& names) {
  std::vector<BenchMethod> methods;
  for (const std::string& name : names)
    for (const BenchMethod& method : parse_bench_methods(name))
      methods.push_back(method);
  if (names.empty()) methods = bench_methods();
  std::vector<Job> jobs;
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    for (const BenchMethod& method : methods) {
      if (!suits(method, scenes[k])) continue;
      for (const MotionSettings& settings : bench_settings(method, scenes[k]))
        jobs.push_back({k, settings});
    }
  }
  if (jobs.empty())
    throw UsageError("none of these --methods is run on these --scenes: they would take too long");
  return jobs;
}

}  // namespace

ExitCode bench(const BenchOptions& options) {
  const std::vector<BenchScene> scenes = chosen_scenes(options.scenes);
  const std::vector<Job> jobs = plan(scenes, options.methods);
  const StopSignal stop;
  Progress progress(Progress::style_for_stderr(options.quiet), "bench",
                    static_cast<double>(jobs.size()), "rows");
  std::vector<BenchRow> rows;
  for (const Job& job : jobs) {
    stop.check();
    rows.push_back(measure(scenes[job.scene], job.settings, options.budget));
    progress.reached(static_cast<double>(rows.size()));
  }
  progress.end();
  const BenchMachine machine = this_machine();
  if (options.csv != "-") fmt::print("{}", bench_table(rows, machine));
  if (!options.csv.empty()) write_text(options.csv, bench_csv(rows, machine));
  if (options.plot.empty()) return ExitCode::fine;
  const std::vector<std::string> files = draw_bench_plots(rows, machine, options.plot);
  if (!options.quiet) fmt::print(stderr, "wrote {} files into {}\n", files.size(), options.plot);
  return ExitCode::fine;
}

}  // namespace wuerfel
