#include <memory>

#include <nlohmann/json.hpp>

#include "app/cli/argument.h"
#include "app/cli/option_groups.h"
#include "app/commands/batch.h"
#include "app/commands/check_json.h"
#include "app/commands/commands.h"
#include "app/commands/idle_options.h"
#include "app/film/still.h"
#include "app/output/text_output.h"
#include "app/output/why.h"
#include "app/words/explanation.h"

namespace wuerfel {

namespace {

struct ExplainOptions {
  SceneChoice scene;
  StillOptions still;  ///< of the picture
  Language language = Language::en;
  std::string output;
  bool json = false;
};

void draw(const Scene& scene, const ExplainOptions& asked, Notes& notes) {
  StillOptions options = asked.still;
  options.picture.fit = Fit::instant;
  options.why = asked.language;
  TextOutput output(asked.output);
  const StopSignal stop;
  Font font;
  const Still still = compose_still(scene, options, stop, font);
  note_labels_left_out(still.labels_left_out, notes);
  output.write(encode_still(still, asked.output, options.picture.encoder, font));
  output.finish();
}

ExitCode explain(const ExplainOptions& asked, const Options& options) {
  Notes notes;
  const bool drawn = options.given("--output");
  if (!drawn) {
    note_idle(options, {"--size", "--theme"}, "without a picture, -o", notes);
  } else {
    require_no_stdout("-o", asked.output);
    require_still_name(asked.output);
  }
  const Scene scene = read_scene(asked.scene);
  note_idle_solver(options, scene, notes);
  const Explanation explanation = explain(scene, asked.still.motion);
  if (drawn) draw(scene, asked, notes);
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
  asked->still.picture.layers = {Layer::cubes, Layer::names, Layer::hud};
  add_scene(options, asked->scene);
  add_choice(options, "--language", "of the sentences", asked->language);
  options.text("-o,--output", "FILE", "a picture of it: .png, sharp at any size .svg .pdf",
               asked->output);
  options.single(
      "--size", "WxH", "pixels of the picture [1280x720]",
      [asked](const std::string& text) { asked->still.picture.size = parse_pixel_size(text); });
  add_choice(options, "--theme", "of the picture", asked->still.picture.theme);
  options.flag("--json", "print the answer as JSON", asked->json);
  add_solver_options(options, asked->still.motion);
  return [asked, &options](const Stopwatch&) { return explain(*asked, options); };
}

}  // namespace wuerfel
