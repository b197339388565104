#include "app/command_line.h"

#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "app/choice.h"
#include "app/commands.h"
#include "app/picture_outputs.h"
#include "render/error.h"
#include "render/view.h"

namespace wuerfel {

namespace {

using Text = std::string;

// An option whose text goes through `take`, which throws UsageError where it is not understood.
template <typename Take>
CLI::Option* add_value(
    CLI::App& app, const Text& names, const Text& type, const Text& meaning, Take take) {
  return app
      .add_option_function<std::vector<Text>>(
          names,
          [take](const std::vector<Text>& values) {
            for (const Text& value : values)
              take(value);
          },
          meaning)
      ->type_name(type)
      ->allow_extra_args(false);
}

void once(CLI::Option* option) { option->expected(1); }

void add_scene(CLI::App& app, SceneChoice& scene) {
  app.add_option("SCENE", scene.source,
                 "scene file (TOML or JSON), - for standard input, or a shipped scene")
      ->required()
      ->type_name("");
  add_value(app, "--set", "KEY=VALUE",
            "override a key of the scene, as in cube.a.angle=0.1 (repeatable)",
            [&scene](const Text& text) { scene.overrides.push_back(text); });
}

template <typename Enum>
void add_choice(CLI::App& app, const Text& name, const Text& meaning, Enum& value) {
  const Text help =
      fmt::format("{}: {} [{}]", meaning, join_choices(choices<Enum>()), to_string(value));
  once(add_value(app, name, "NAME", help,
                 [name, &value](const Text& text) { value = parse_choice<Enum>(name, text); }));
}

void add_motion_options(CLI::App& app, MotionSettings& motion) {
  add_choice(app, "--integrator", "how time is stepped", motion.integrator);
  add_choice(app, "--formulation", "unknowns of the program", motion.formulation);
  add_choice(app, "--solver", "who solves the program", motion.solver);
  once(add_value(
      app, "--tolerance", "TOL", "error budget of states [1e-8]",
      [&motion](const Text& text) { motion.tolerance = parse_positive("--tolerance", text); }));
  once(add_value(app, "--step", "DT", "time step in s [1/240]",
                 [&motion](const Text& text) { motion.step = parse_positive("--step", text); }));
}

void add_picture_options(CLI::App& app, PictureOptions& picture) {
  once(add_value(app, "--size", "WxH", "pixels [1280x720]",
                 [&picture](const Text& text) { picture.size = parse_pixel_size(text); }));
  const Text layers = fmt::format("what is drawn: any of {} [{}]", join_choices(choices<Layer>()),
                                  to_string(picture.layers));
  once(add_value(app, "--layers", "A,B,..", layers,
                 [&picture](const Text& text) { picture.layers = parse_layers(text); }));
  const Text theme =
      fmt::format("colours: {} [{}]", join_choices(choices<Theme>()), to_string(picture.theme));
  once(add_value(app, "--theme", "NAME", theme,
                 [&picture](const Text& text) { picture.theme = parse_theme(text); }));
  once(add_value(app, "--force-scale", "M/N", "length of force arrows in m per N [fits the run]",
                 [&picture](const Text& text) {
                   picture.force_scale = parse_positive("--force-scale", text);
                 }));
  once(add_value(app, "--view", "fit|X,Y,WIDTH", "part of the world in m: centre and width [fit]",
                 [&picture](const Text& text) {
                   if (text != "fit") parse_view(text, picture.size.width, picture.size.height);
                   picture.view = text;
                 }));
}

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
  once(add_value(
      *app, "--fps", "F", "frames per second of the film [60]",
      [&options](const Text& text) { options.rate.fps = parse_positive("--fps", text); }));
  once(add_value(
      *app, "--speed", "X", "simulated time per film time, 0.1 is slow motion [1]",
      [&options](const Text& text) { options.rate.speed = parse_positive("--speed", text); }));
  once(add_value(*app, "--until", "T", "end in s [the scene's duration]",
                 [&options](const Text& text) { options.until = parse_time("--until", text); }));
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
  once(add_value(*app, "-t,--time", "T", "instant in s [0]",
                 [&options](const Text& text) { options.time = parse_time("-t", text); }));
  app->add_option("-o,--output", options.output, "picture: .png")->type_name("FILE")->required();
  add_picture_options(*app, options.picture);
  add_motion_options(*app, options.motion);
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
  Text scene_name;
  const CLI::App* run_app = add_run(program, run_options);
  const CLI::App* check_app = add_check(program, check_options);
  const CLI::App* figure_app = add_figure(program, figure_options);
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
  if (scenes_app->parsed()) return [scene_name] { return scenes(scene_name); };
  return [] { return schema(); };
}

}  // namespace wuerfel
