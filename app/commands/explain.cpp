#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/cli/option_groups.h"
#include "app/commands/batch.h"
#include "app/commands/commands.h"
#include "app/commands/idle_options.h"
#include "app/output/text_output.h"
#include "app/output/why.h"
#include "app/words/explanation.h"

namespace wuerfel {

namespace {

struct ExplainOptions {
  SceneChoice scene;
  MotionSettings motion;
  Language language = Language::en;
  bool json = false;
};

// As of `check`.
ExitCode exit_code(Verdict verdict) {
  switch (verdict) {
    case Verdict::stands:
      return ExitCode::fine;
    case Verdict::falls:
    case Verdict::moves:
      return ExitCode::negative;
    case Verdict::undecided:
      return ExitCode::undecided;
  }
  return ExitCode::internal;
}

ExitCode explain(const ExplainOptions& asked, const Options& options) {
  const Scene scene = read_scene(asked.scene);
  Notes notes;
  note_idle_solver(options, scene, notes);
  const Explanation explanation = explain(scene, asked.motion);
  const std::vector<std::string> text = sentences(scene, explanation, asked.language);
  if (asked.json) {
    write_text("-", json_text(why_json(explanation, text), {true, false}));
  } else {
    std::string lines;
    for (const std::string& sentence : text)
      lines += sentence + "\n";
    write_text("-", lines);
  }
  return exit_code(explanation.check.verdict);
}

}  // namespace

Action declare_explain(Options& options) {
  auto asked = std::make_shared<ExplainOptions>();
  add_scene(options, asked->scene);
  add_choice(options, "--language", "of the sentences", asked->language);
  options.flag("--json", "print the answer as JSON", asked->json);
  add_solver_options(options, asked->motion);
  return [asked, &options](const Stopwatch&) { return explain(*asked, options); };
}

}  // namespace wuerfel
