#include "app/command_line.h"

#include <cmath>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "app/commands.h"
#include "app/option_groups.h"
#include "app/picture_outputs.h"
#include "render/error.h"

namespace wuerfel {

namespace {

using Text = std::string;

// Only one thing at a time may go to standard output.
void require_one_on_stdout(const RunOptions& options) {
  int users = options.json ? 1 : 0;
  for (const Text* file : {&options.states, &options.forces, &options.events, &options.summary}) {
    if (*file == "-") ++users;
  }
  if (users > 1) throw UsageError("only one of --json and the files can be standard output");
}

void require_png(const Text& name) {
  if (!name.ends_with(".png")) throw UsageError(fmt::format("-o: '{}' does not end in .png", name));
}

CLI::App* add_run(CLI::App& program, RunOptions& options) {
  CLI::App* app =
      program.add_subcommand("run", "simulate a scene and write frames, films and tables");
  add_scene(*app, options.scene);
  add_value(*app, "-o,--output", "DIR/|FILE",
            "folder of frames, or a film: .mp4 .webm .gif .apng (repeatable)",
            [&options](const Text& text) {
              require_picture_output(text);
              options.outputs.push_back(text);
            });
  add_single(*app, "--fps", "F", "frames per second of the film [60]",
             [&options](const Text& text) { options.rate.fps = parse_positive("--fps", text); });
  add_single(
      *app, "--speed", "X", "simulated time per film time, 0.1 is slow motion [1]",
      [&options](const Text& text) { options.rate.speed = parse_positive("--speed", text); });
  add_single(*app, "--until", "T", "end in s [the scene's duration]",
             [&options](const Text& text) { options.until = parse_time("--until", text); });
  add_value(*app, "--sample", "T1,T2,..", "report the state at these times",
            [&options](const Text& text) {
              for (const Text& time : split_list(text))
                options.samples.push_back(parse_time("--sample", time));
            });
  app->add_option("--states", options.states, "positions and velocities at the frame times as CSV")
      ->type_name("FILE");
  app->add_option("--forces", options.forces, "contact forces at the frame times as CSV")
      ->type_name("FILE");
  app->add_option("--events", options.events, "events as JSON lines")->type_name("FILE");
  app->add_option("--summary", options.summary, "the summary as JSON")->type_name("FILE");
  app->add_flag("--json", options.json, "print the summary as JSON");
  app->add_flag("--quiet", options.quiet, "no progress and no notes");
  add_picture_options(*app, options.picture);
  add_motion_options(*app, options.motion);
  return app;
}

CLI::App* add_check(CLI::App& program, CheckOptions& options) {
  CLI::App* app = program.add_subcommand(
      "check", "tell whether a scene stands: exit 0 stands, 1 falls or moves, 3 undecided");
  add_scene(*app, options.scene);
  app->add_flag("--json", options.json, "print the answer as JSON");
  add_motion_options(*app, options.motion);
  return app;
}

CLI::App* add_figure(CLI::App& program, FigureOptions& options) {
  CLI::App* app = program.add_subcommand("figure", "draw one instant");
  add_scene(*app, options.scene);
  add_single(*app, "-t,--time", "T", "instant in s [0]",
             [&options](const Text& text) { options.time = parse_time("-t", text); });
  app->add_option("-o,--output", options.output, "picture: .png")->type_name("FILE")->required();
  add_picture_options(*app, options.picture);
  add_motion_options(*app, options.motion);
  return app;
}

int parse_difference(const Text& text) {
  const double value = parse_number("--max-difference", text);
  if (value < 0.0 || value > 255.0 || value != std::floor(value))
    throw UsageError(fmt::format("--max-difference: '{}' is no whole number of 0 to 255", text));
  return static_cast<int>(value);
}

double parse_share(const Text& text) {
  const double value = parse_number("--max-share", text);
  if (value < 0.0 || value > 1.0)
    throw UsageError(fmt::format("--max-share: {} is not between 0 and 1", text));
  return value;
}

CLI::App* add_compare(CLI::App& program, CompareOptions& options) {
  CLI::App* app = program.add_subcommand(
      "compare", "tell whether pictures, or folders of them, are the same: exit 0 same, 1 differs");
  app->add_option("EXPECTED", options.expected, ".png file or folder")->required()->type_name("");
  app->add_option("ACTUAL", options.actual, "the same of what is there now")
      ->required()
      ->type_name("");
  app->add_option("-o,--output", options.output,
                  "expected, actual and difference side by side, where pixels differ; a folder "
                  "where folders are compared")
      ->type_name("DIFF.png");
  add_single(
      *app, "--max-difference", "N", "of a channel (0 to 255) that still counts as same [4]",
      [&options](const Text& text) { options.limits.largest_difference = parse_difference(text); });
  add_single(*app, "--max-share", "S", "of pixels (0 to 1) that may differ that much [0.05]",
             [&options](const Text& text) { options.limits.largest_share = parse_share(text); });
  app->add_flag("--update", options.update, "accept: copy ACTUAL over EXPECTED where they differ");
  app->add_flag("--json", options.json, "print the answer as JSON");
  return app;
}

}  // namespace

std::optional<Command> parse_command_line(int argc,
                                          const char* const* argv,
                                          const Stopwatch& since_start) {
  CLI::App program("Falling cubes in the plane by Gauss' principle of least constraint.",
                   "wuerfel");
  program.set_version_flag("--version", "wuerfel " WUERFEL_VERSION);
  program.require_subcommand(1);

  RunOptions run_options;
  run_options.since_start = since_start;
  CheckOptions check_options;
  FigureOptions figure_options;
  CompareOptions compare_options;
  Text scene_name;
  const CLI::App* run_app = add_run(program, run_options);
  const CLI::App* check_app = add_check(program, check_options);
  const CLI::App* figure_app = add_figure(program, figure_options);
  const CLI::App* compare_app = add_compare(program, compare_options);
  CLI::App* scenes_app =
      program.add_subcommand("scenes", "list the scenes that come along, or print one");
  scenes_app->add_option("NAME", scene_name, "scene to print")->type_name("");
  program.add_subcommand("schema", "print the JSON Schema of scenes");

  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& answer) {
    if (answer.get_exit_code() != 0)
      throw UsageError(fmt::format("{} (see wuerfel --help)", answer.what()));
    program.exit(answer);
    return std::nullopt;
  } catch (const RenderError& error) {
    throw UsageError(error.what());
  }
  if (run_app->parsed()) require_one_on_stdout(run_options);
  if (figure_app->parsed()) require_png(figure_options.output);
  if (run_app->parsed()) return [run_options] { return run(run_options); };
  if (check_app->parsed()) return [check_options] { return check(check_options); };
  if (figure_app->parsed()) return [figure_options] { return figure(figure_options); };
  if (compare_app->parsed()) return [compare_options] { return compare(compare_options); };
  if (scenes_app->parsed()) return [scene_name] { return scenes(scene_name); };
  return [] { return schema(); };
}

}  // namespace wuerfel
