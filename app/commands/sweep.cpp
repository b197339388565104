#include "app/commands/sweep.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/argument.h"
#include "app/cli/option_groups.h"
#include "app/cli/progress.h"
#include "app/cli/streams.h"
#include "app/commands/batch.h"
#include "app/commands/sweep_results.h"
#include "app/output/text_output.h"
#include "app/sweep/dataset.h"
#include "app/sweep/engine_templates.h"
#include "app/sweep/plan.h"
#include "app/sweep/sweep_run.h"
#include "core/scene/suggestion.h"

namespace wuerfel {

namespace {

struct PlanOptions {
  std::string sweep;
  std::string folder;
  std::optional<long> cases;
  int threads = 0;
  bool dry_run = false;
};

void say_counts(const PlanCounts& counts) {
  std::string splits;
  for (const auto& [name, count] : counts.splits)
    splits += fmt::format("{}{} {}", splits.empty() ? "" : ", ", name, count);
  say(fmt::format("wuerfel: {} cases of {} draws ({}); {}\n", counts.cases, counts.drawn, splits,
                  describe(counts.rejected)));
}

SceneText sweep_text(const std::string& source) {
  std::error_code ignored;
  if (source != "-" && !std::filesystem::exists(source, ignored))
    throw UsageError(fmt::format("{}: no such file", source));
  return scene_text(source);
}

ExitCode plan(const PlanOptions& asked) {
  if (asked.folder.empty() && !asked.dry_run)
    throw UsageError("sweep plan: -o PLAN is missing (or --dry-run)");
  const StopSignal stop;
  const SweepText text(sweep_text(asked.sweep), {}, asked.cases);
  Progress bar(Progress::style_for_stderr(false), "drawing", static_cast<double>(text.sweep.cases),
               "cases");
  const PlanCounts counts = make_plan(text, asked.dry_run ? "" : asked.folder, asked.threads, stop,
                                      [&](long cases) { bar.reached(static_cast<double>(cases)); });
  bar.end();
  say_counts(counts);
  return ExitCode::fine;
}

constexpr long most_cases = 100'000'000;

Action declare_plan(Options& options) {
  auto asked = std::make_shared<PlanOptions>();
  options.argument("SWEEP", "sweep file (TOML or JSON), - for standard input", asked->sweep);
  options.text("-o,--output", "PLAN", "folder of the plan; must not be there yet", asked->folder);
  options.single("--cases", "N", "this many cases, whatever the file says",
                 [asked](const std::string& text) {
                   asked->cases = parse_whole("--cases", text, 1, most_cases);
                 });
  add_jobs_option(options, asked->threads);
  options.flag("--dry-run", "draw the cases and say how many there are, write nothing",
               asked->dry_run);
  return [asked](const Stopwatch&) { return plan(*asked); };
}

struct RunCommand {
  std::string plan;
  RunChoice choice;
  bool shard_given = false;
  bool quiet = false;
};

Shard shard_of(const RunCommand& asked) {
  if (asked.shard_given) return asked.choice.shard;
  const std::optional<EngineShard> engine = shard_of_engine();
  if (!engine) return {};
  if (!asked.quiet) {
    say(fmt::format("wuerfel: shard {} of {}, by {}\n", engine->shard.index, engine->shard.count,
                    engine->variable));
  }
  return engine->shard;
}

ExitCode run(const RunCommand& asked) {
  const Plan plan(asked.plan);
  RunChoice choice = asked.choice;
  choice.shard = shard_of(asked);
  const StopSignal stop;
  std::optional<Progress> bar;
  const RunReport report = run_plan(plan, choice, stop, [&](long done, long all) {
    if (!bar) {
      bar.emplace(Progress::style_for_stderr(asked.quiet), "sampling", static_cast<double>(all),
                  "samples");
    }
    bar->reached(static_cast<double>(done));
  });
  if (bar) bar->end();
  if (!asked.quiet || report.failed > 0) {
    say(fmt::format("wuerfel: {} samples made, {} failed, {} left\n", report.made, report.failed,
                    report.left));
  }
  if (report.left > 0) return ExitCode::again;
  return report.failed > 0 ? ExitCode::undecided : ExitCode::fine;
}

Action declare_sweep_run(Options& options) {
  auto asked = std::make_shared<RunCommand>();
  options.argument("PLAN", "folder of a plan", asked->plan);
  options.single("--shard", "I/N",
                 "this part of the cases, I from 0 [what Slurm or MPI says, or all]",
                 [asked](const std::string& text) {
                   asked->choice.shard = parse_shard(text);
                   asked->shard_given = true;
                 });
  add_jobs_option(options, asked->choice.threads);
  add_memory_option(options);
  options.single("--time-budget", "TIME",
                 "begin no sample afterwards, as 3h50m: exit code 75 where some are left",
                 [asked](const std::string& text) {
                   asked->choice.budget_s = parse_time_span("--time-budget", text);
                 });
  options.flag("--retry-failed", "try cases that failed once more", asked->choice.retry_failed);
  options.flag("--quiet", "no progress", asked->quiet);
  return [asked](const Stopwatch&) { return run(*asked); };
}

struct VerifyOptions {
  std::string dataset;
  VerifyChoice choice;
  bool json = false;
};

ExitCode verify(const VerifyOptions& asked) {
  const StopSignal stop;
  const VerifyReport report = verify_dataset(asked.dataset, asked.choice, stop);
  if (asked.json) {
    write_text("-", json_text({{"checked", report.checked},
                               {"near", report.near},
                               {"differences", report.differences}},
                              {true, false}));
  } else {
    for (const std::string& difference : report.differences)
      write_text("-", difference + "\n");
    write_text("-", fmt::format("{} samples made again, {} differences{}\n", report.checked,
                                report.differences.size(),
                                report.near > 0 ? fmt::format(
                                    ", pictures of {} equal but for rounding", report.near)
                                                : ""));
  }
  return report.differences.empty() ? ExitCode::fine : ExitCode::negative;
}

Action declare_verify(Options& options) {
  auto asked = std::make_shared<VerifyOptions>();
  options.argument("DATASET", "folder of a data set", asked->dataset);
  options.text("--id", "ID", "this sample alone", asked->choice.id);
  options.single("--sample", "N", "so many samples, evenly spread; 0: all [100]",
                 [asked](const std::string& text) {
                   asked->choice.sample = parse_whole("--sample", text, 0, most_cases);
                 });
  add_jobs_option(options, asked->choice.threads);
  options.flag("--json", "print the result as JSON", asked->json);
  return [asked](const Stopwatch&) { return verify(*asked); };
}

Action declare_template(Options& options) {
  auto engine = std::make_shared<std::string>();
  std::vector<std::string> names;
  for (const EngineTemplate& one : engine_templates())
    names.emplace_back(one.engine);
  options.argument("ENGINE", join_choices(names), *engine);
  return [engine](const Stopwatch&) {
    const auto found = std::ranges::find(engine_templates(), *engine, &EngineTemplate::engine);
    if (found == engine_templates().end()) {
      throw UsageError(
          fmt::format("there is no template for {}{}", *engine,
                      suggestion(*engine, engine_templates(), &EngineTemplate::engine)));
    }
    write_text("-", found->text);
    return ExitCode::fine;
  };
}

constexpr std::array parts{
    Command{"plan", "draw the cases of a sweep", declare_plan},
    Command{"run", "make the samples of a plan, or of a shard: exit 75 out of time",
            declare_sweep_run},
    Command{"status", "tell how far it is: exit 0 complete, 1 not yet", declare_status},
    Command{"merge", "make a data set of the samples", declare_merge},
    Command{"verify", "make samples of a data set again: exit 0 same, 1 differs", declare_verify},
    Command{"sheet", "draw many first frames in one picture", declare_sheet},
    Command{"template", "print a script for Slurm, GNU parallel, make or Snakemake",
            declare_template},
};

}  // namespace

std::span<const Command> sweep_commands() { return parts; }

}  // namespace wuerfel
