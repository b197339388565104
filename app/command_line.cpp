#include "app/command_line.h"

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

void require_still(const FigureOptions& options) {
  const Text& name = options.output;
  if (!name.ends_with(".png") && !vector_format(name))
    throw UsageError(fmt::format("-o: '{}' does not end in .png, .svg or .pdf", name));
  const auto& strip = options.still.strip;
  const std::size_t room = strip ? strip->columns * strip->rows : 1;
  if (options.times.size() > room) {
    throw UsageError(strip ? fmt::format("-t: {} times do not fit into a strip of {}",
                                         options.times.size(), room)
                           : "-t: several times need a --strip such as 4x2");
  }
  if (options.until && (!strip || !options.times.empty()))
    throw UsageError("--until is the end of a --strip whose times are not given");
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
  add_rate_options(*app, options.rate);
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
  add_encoder_option(*app, options.picture.encoder);
  add_motion_options(*app, options.motion);
  return app;
}

CLI::App* add_check(CLI::App& program, CheckOptions& options) {
  CLI::App* app = program.add_subcommand(
      "check", "tell whether a scene stands: exit 0 stands, 1 falls or moves, 3 undecided");
  add_scene(*app, options.scene);
  app->add_flag("--json", options.json, "print the answer as JSON");
  add_program_options(*app, options.motion);
  refuse_motion_options(*app);
  return app;
}

CLI::App* add_figure(CLI::App& program, FigureOptions& options) {
  CLI::App* app = program.add_subcommand("figure", "draw one instant, or a strip of several");
  add_scene(*app, options.scene);
  add_value(*app, "-t,--time", "T1,T2,..", "instant in s, several for a strip [0]",
            [&options](const Text& text) {
              for (const Text& time : split_list(text))
                options.times.push_back(parse_time("-t", time));
            });
  add_strip_option(*app, options.still.strip);
  add_single(*app, "--until", "T", "end of the even times of a strip in s [the scene's duration]",
             [&options](const Text& text) { options.until = parse_time("--until", text); });
  app->add_option("-o,--output", options.output, "picture: .png, or sharp at any size .svg .pdf")
      ->type_name("FILE")
      ->required();
  add_picture_options(*app, options.still.picture);
  add_encoder_option(*app, options.still.picture.encoder);
  add_motion_options(*app, options.still.motion);
  return app;
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
  add_compare_limits(*app, options.limits);
  app->add_flag("--update", options.update, "accept: copy ACTUAL over EXPECTED where they differ");
  app->add_flag("--json", options.json, "print the answer as JSON");
  return app;
}

CLI::App* add_reproduce(CLI::App& program, ReproduceOptions& options) {
  CLI::App* app = program.add_subcommand(
      "reproduce", "make a picture again from what it carries: exit 0 same, 1 differs");
  app->add_option("FRAME", options.picture, ".png file that `run` or `figure` made")
      ->required()
      ->type_name("");
  app->add_option("-o,--output", options.output, "the picture made again")->type_name("FILE.png");
  add_compare_limits(*app, options.limits);
  app->add_flag("--json", options.json, "print the answer as JSON");
  return app;
}

CLI::App* add_bench(CLI::App& program, BenchOptions& options) {
  CLI::App* app = program.add_subcommand(
      "bench", "measure run time against error on scenes with exact answers");
  add_value(*app, "--scenes", "A,B,..",
            "flight, tilt, ..., overhang, tower_N, pyramid_N, wall_N, pile_N, mass_ratio_N [all]",
            [&options](const Text& text) {
              for (const Text& name : split_list(text))
                options.scenes.push_back(name);
            });
  add_value(*app, "--methods", "A,B,..",
            "INTEGRATOR[/FORMULATION[/SOLVER]], such as event or symplectic/points [all]",
            [&options](const Text& text) {
              for (const Text& name : split_list(text))
                options.methods.push_back(name);
            });
  app->add_option("--csv", options.csv, "all figures as CSV")->type_name("FILE");
  app->add_option("--plot", options.plot, "folder of plots; needs gnuplot")->type_name("DIR");
  add_single(*app, "--budget", "S", "processor time for repeats of each row in s [0.1]",
             [&options](const Text& text) { options.budget = parse_time("--budget", text); });
  app->add_flag("--quiet", options.quiet, "no progress and no notes");
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
  ReproduceOptions reproduce_options;
  BenchOptions bench_options;
  Text scene_name;
  const CLI::App* run_app = add_run(program, run_options);
  const CLI::App* check_app = add_check(program, check_options);
  const CLI::App* figure_app = add_figure(program, figure_options);
  const CLI::App* compare_app = add_compare(program, compare_options);
  const CLI::App* reproduce_app = add_reproduce(program, reproduce_options);
  const CLI::App* bench_app = add_bench(program, bench_options);
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
  if (run_app->parsed()) {
    require_one_on_stdout(run_options);
    require_effect(*run_app, run_options.motion);
  }
  if (figure_app->parsed()) {
    require_still(figure_options);
    require_effect(*figure_app, figure_options.still.motion);
  }
  if (run_app->parsed()) return [run_options] { return run(run_options); };
  if (check_app->parsed()) return [check_options] { return check(check_options); };
  if (figure_app->parsed()) return [figure_options] { return figure(figure_options); };
  if (compare_app->parsed()) return [compare_options] { return compare(compare_options); };
  if (reproduce_app->parsed()) return [reproduce_options] { return reproduce(reproduce_options); };
  if (bench_app->parsed()) return [bench_options] { return bench(bench_options); };
  if (scenes_app->parsed()) return [scene_name] { return scenes(scene_name); };
  return [] { return schema(); };
}

}  // namespace wuerfel
