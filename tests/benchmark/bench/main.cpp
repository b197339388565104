/// Measures run time against error on scenes with exact answers.
///
///     build/release/tests/benchmark/bench/bench [--scenes A,B] [--methods A,B] [--csv FILE] [--plot DIR]
#include <exception>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "app/cli/argument.h"
#include "app/cli/exit_code.h"
#include "app/cli/options.h"
#include "app/cli/progress.h"
#include "app/cli/stop_signal.h"
#include "app/cli/streams.h"
#include "app/output/text_output.h"
#include "tests/benchmark/bench/measure.h"
#include "tests/benchmark/bench/plot.h"

namespace {

using namespace wuerfel;

struct BenchOptions {
  std::vector<std::string> scenes;   ///< none: all
  std::vector<std::string> methods;  ///< INTEGRATOR[/FORMULATION[/SOLVER]]; none: all
  std::string csv;                   ///< file name, empty: not wanted, `-`: standard output
  std::string plot;                  ///< folder, empty: no plots
  double budget = 0.1;               ///< s of repeats for every row
  bool quiet = false;
};

void declare(BenchOptions& asked, Options& options) {
  const auto list_into = [](std::vector<std::string>& names) {
    return [&names](const std::string& text) {
      for (const std::string& name : split_list(text))
        names.push_back(name);
    };
  };
  options.value("--scenes", "A,B,..",
                "flight, tilt, ..., overhang, tower_N, pyramid_N, wall_N, pile_N, mass_ratio_N, "
                "tilt_on_wall_N [all]",
                list_into(asked.scenes));
  options.value("--methods", "A,B,..",
                "INTEGRATOR[/FORMULATION[/SOLVER]], such as event or symplectic/points [all]",
                list_into(asked.methods));
  options.text("--csv", "FILE", "all figures as CSV", asked.csv);
  options.text("--plot", "DIR", "folder of plots; needs gnuplot", asked.plot);
  options.single(
      "--budget", "S", "processor time for repeats of each row in s [0.1]",
      [&asked](const std::string& text) { asked.budget = parse_time("--budget", text); });
  options.flag("--quiet", "no progress and no notes", asked.quiet);
}

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
  for (const std::string& name : names) {
    for (const BenchMethod& method : parse_bench_methods(name))
      methods.push_back(method);
  }
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

void bench(const BenchOptions& options) {
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
  if (options.csv != "-") write_text("-", bench_table(rows, machine));
  if (!options.csv.empty()) write_text(options.csv, bench_csv(rows, machine));
  if (options.plot.empty()) return;
  const std::vector<std::string> files = draw_bench_plots(rows, machine, options.plot);
  if (!options.quiet) say(fmt::format("wrote {} files into {}\n", files.size(), options.plot));
}

}  // namespace

int main(int argc, char** argv) {
  try {
    BenchOptions asked;
    Options options("bench", "Measures run time against error on scenes with exact answers.");
    declare(asked, options);
    if (options.parse({argv + 1, argv + argc})) {
      bench(asked);
    } else {
      write_text("-", options.help());
    }
  } catch (const UsageError& error) {
    say(fmt::format("bench: {}\n", error.what()));
    return static_cast<int>(ExitCode::bad_input);
  } catch (const Interrupted& interrupted) {
    return 128 + interrupted.signal;
  } catch (const std::exception& error) {
    say(fmt::format("bench: {}\n", error.what()));
    return static_cast<int>(ExitCode::internal);
  }
  return 0;
}
