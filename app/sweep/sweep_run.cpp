#include "app/sweep/sweep_run.h"

#include <unordered_set>

#include "app/cli/stopwatch.h"
#include "app/sweep/sample.h"
#include "core/work_in_order.h"
#include "render/error.h"

namespace wuerfel {

namespace {

struct Made {
  Case one;
  std::string blocks;
  std::string error;
  double cpu_s = 0.0;
};

Made make(SampleMaker& maker, Case one) {
  Made made{std::move(one), "", "", 0.0};
  const Stopwatch watch(Stopwatch::Of::thread);
  try {
    made.blocks = tape_blocks(maker.files(made.one));
  } catch (const OutputError&) {
    throw;
  } catch (const std::exception& error) {
    made.error = error.what();
  }
  made.cpu_s = watch.cpu();
  return made;
}

/// The numbers of cases that need no more work.
std::unordered_set<long> finished_cases(const Plan& plan, bool retry_failed) {
  const Journal journal(plan);
  std::unordered_set<long> finished;
  for (const auto& [number, entry] : journal.entries())
    if (entry.error.empty() || !retry_failed) finished.insert(number);
  return finished;
}

long cases_of(const Shard& shard, long cases) {
  return (cases - shard.index + shard.count - 1) / shard.count;
}

}  // namespace

RunReport run_plan(const Plan& plan,
                   const RunChoice& choice,
                   const StopSignal& stop,
                   const std::function<void(long done, long all)>& progress) {
  const Stopwatch watch;
  const std::unordered_set<long> finished = finished_cases(plan, choice.retry_failed);
  RunReport report;
  report.left = cases_of(choice.shard, plan.cases());
  for (const long number : finished)
    if (choice.shard.holds(number)) --report.left;
  const long all = report.left;
  ShardWriter writer(plan, choice.shard);
  SampleMaker maker(plan.sweep(), stop);
  if (all > 0) maker.prepare();
  Manifest manifest(plan);
  const auto next = [&]() -> std::optional<Case> {
    if (choice.budget_s && watch.wall() >= *choice.budget_s) return std::nullopt;
    std::optional<Case> one = manifest.next();
    while (one && (!choice.shard.holds(one->number) || finished.contains(one->number)))
      one = manifest.next();
    return one;
  };
  const auto deliver = [&](const Made& made) {
    if (made.error.empty()) {
      writer.add(made.one, made.blocks, made.cpu_s);
      ++report.made;
    } else {
      writer.add_failure(made.one, made.error);
      ++report.failed;
    }
    progress(all - --report.left, all);
  };
  work_in_order(
      {thread_count(choice.threads), [&stop] { stop.check(); }}, next,
      [&maker](Case one) { return make(maker, std::move(one)); }, deliver);
  writer.flush();
  return report;
}

}  // namespace wuerfel
