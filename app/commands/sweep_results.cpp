#include "app/commands/sweep_results.h"

#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/argument.h"
#include "app/cli/option_groups.h"
#include "app/cli/picture_values.h"
#include "app/cli/streams.h"
#include "app/commands/batch.h"
#include "app/output/text_output.h"
#include "app/sweep/dataset.h"
#include "app/sweep/plan.h"
#include "app/sweep/sheet.h"
#include "app/sweep/sweep_run.h"

namespace wuerfel {

namespace {

struct StatusOptions {
  std::string plan;
  bool json = false;
};

ExitCode status(const StatusOptions& asked) {
  const Plan plan(asked.plan);
  const Journal journal(plan);
  long failed = 0;
  double cpu_s = 0.0;
  for (const auto& [number, entry] : journal.entries()) {
    if (!entry.error.empty()) ++failed;
    cpu_s += entry.cpu_s;
  }
  const long done = static_cast<long>(journal.entries().size()) - failed;
  const long left = plan.cases() - done - failed;
  if (asked.json) {
    write_text("-", json_text({{"name", plan.sweep().name},
                               {"cases", plan.cases()},
                               {"done", done},
                               {"failed", failed},
                               {"left", left},
                               {"splits", plan.counts().splits},
                               {"cpu_s", cpu_s}},
                              {true, false}));
  } else {
    write_text("-", fmt::format(
                        "{}: {} of {} cases done, {} failed, {} left; {:.1f} s of processor time\n",
                        plan.sweep().name, done, plan.cases(), failed, left, cpu_s));
  }
  return left > 0 ? ExitCode::negative : ExitCode::fine;
}

struct MergeOptions {
  std::string plan;
  std::string dataset;
};

ExitCode merge(const MergeOptions& asked) {
  const Plan plan(asked.plan);
  const StopSignal stop;
  const DatasetCounts counts = merge_dataset(plan, asked.dataset, stop);
  say(fmt::format("wuerfel: {} samples in {}{}\n", counts.samples, asked.dataset,
                  counts.failed > 0 ? fmt::format(", without {} that failed", counts.failed) : ""));
  return ExitCode::fine;
}

struct SheetOptions {
  std::string plan;
  std::string file;
  SheetChoice choice;
};

ExitCode sheet(const SheetOptions& asked) {
  require_suffix("-o", asked.file, ".png");
  if (asked.choice.size && asked.choice.size->height == 0)
    throw UsageError("--size: the height of a sheet has to be told, as 1600x1760");
  const Plan plan(asked.plan);
  const StopSignal stop;
  Font font;
  const Still still = contact_sheet(plan, asked.choice, stop, font);
  write_png(asked.file, draw_still(still), still.origin);
  return ExitCode::fine;
}

}  // namespace

Action declare_status(Options& options) {
  auto asked = std::make_shared<StatusOptions>();
  options.argument("PLAN", "folder of a plan", asked->plan);
  options.flag("--json", "print it as JSON", asked->json);
  return [asked](const Stopwatch&) { return status(*asked); };
}

Action declare_merge(Options& options) {
  auto asked = std::make_shared<MergeOptions>();
  options.argument("PLAN", "folder of a plan, all of it run", asked->plan);
  options.required_text("-o,--output", "DATASET", "folder of the data set; must not be there yet",
                        asked->dataset);
  return [asked](const Stopwatch&) { return merge(*asked); };
}

Action declare_sheet(Options& options) {
  auto asked = std::make_shared<SheetOptions>();
  options.argument("PLAN", "folder of a plan, or plan/ of a data set", asked->plan);
  options.required_text("-o,--output", "FILE.png", "the picture", asked->file);
  options.single("--strip", "CxR", "columns and rows [8x8]",
                 [asked](const std::string& text) { asked->choice.grid = parse_strip(text); });
  options.single("--size", "WxH", "size in pixels [1600x1760, lower where there are fewer cases]",
                 [asked](const std::string& text) { asked->choice.size = parse_pixel_size(text); });
  return [asked](const Stopwatch&) { return sheet(*asked); };
}

}  // namespace wuerfel
