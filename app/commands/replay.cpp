#include "app/output/replay.h"

#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/commands/batch.h"
#include "app/commands/commands.h"
#include "app/output/text_output.h"
#include "core/qp/qp_solver.h"

namespace wuerfel {

namespace {

using Json = nlohmann::ordered_json;

struct ReplayOptions {
  std::string file;
  bool json = false;
};

std::string text_of(const Json& replay) {
  std::string text = fmt::format("program {}: {} unknowns, {} rows\n", replay["program"].get<int>(),
                                 replay["unknowns"].get<int>(), replay["rows"].get<int>());
  for (const Json& answer : replay["answers"]) {
    text += fmt::format("  {:<16} {:<12} residual {:<10.3g} {} iterations\n",
                        answer["solver"].get<std::string>(), answer["status"].get<std::string>(),
                        answer["residual"].is_null() ? 0.0 : answer["residual"].get<double>(),
                        answer["iterations"].get<int>());
  }
  return text;
}

ExitCode replay(const ReplayOptions& asked) {
  bool solved = true;
  replay_programs(asked.file, [&](const Json& replay) {
    const auto status = replay["answers"][0]["status"].get<std::string>();
    solved = solved && status == to_string(QpStatus::optimal);
    write_text("-", asked.json ? replay.dump() + "\n" : text_of(replay));
  });
  return solved ? ExitCode::fine : ExitCode::undecided;
}

}  // namespace

Action declare_replay(Options& options) {
  auto asked = std::make_shared<ReplayOptions>();
  options.argument("FILE", "programs that `run --failed-programs` wrote", asked->file);
  options.flag("--json", "print each answer as a line of JSON", asked->json);
  return [asked](const Stopwatch&) { return replay(*asked); };
}

}  // namespace wuerfel
