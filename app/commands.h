/// The subcommands and what each can be told.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/exit_code.h"
#include "app/picture_options.h"
#include "app/scene_source.h"
#include "app/still.h"
#include "app/stopwatch.h"
#include "app/timetable.h"
#include "core/settings.h"
#include "render/raster/compare.h"

namespace wuerfel {

struct RunOptions {
  SceneChoice scene;
  MotionSettings motion;
  PictureOptions picture;
  FrameRate rate;
  std::optional<double> until;       ///< s; none: the scene's duration
  std::vector<double> samples;       ///< s
  std::vector<std::string> outputs;  ///< folders and films
  std::string states;                ///< file names, empty: not wanted, `-`: standard output
  std::string forces;
  std::string events;
  std::string summary;
  bool json = false;
  bool quiet = false;
  Stopwatch since_start;  ///< runs since the program began
};

struct CheckOptions {
  SceneChoice scene;
  MotionSettings motion;
  bool json = false;
};

struct FigureOptions {
  SceneChoice scene;
  StillOptions still;           ///< but for the times
  std::vector<double> times;    ///< s; none: the start, or even times of a strip
  std::optional<double> until;  ///< s, end of even times; none: the scene's duration
  std::string output;
};

struct CompareOptions {
  std::string expected;
  std::string actual;
  std::string output;  ///< where expected, actual and difference go side by side; empty: nowhere
  CompareLimits limits;
  bool json = false;
  bool update = false;  ///< accept what is different
};

struct ReproduceOptions {
  std::string picture;
  std::string output;  ///< the picture made again; empty: nowhere
  CompareLimits limits;
  bool json = false;
};

struct BenchOptions {
  std::vector<std::string> scenes;   ///< none: all
  std::vector<std::string> methods;  ///< INTEGRATOR[/FORMULATION[/SOLVER]]; none: all
  std::string csv;                   ///< file name, empty: not wanted, `-`: standard output
  std::string plot;                  ///< folder, empty: no plots
  double budget = 0.1;               ///< s of repeats for every row
  bool quiet = false;
};

/// Simulates and writes what was asked for.
ExitCode run(const RunOptions& options);
/// Answers whether the scene stands.
ExitCode check(const CheckOptions& options);
/// Draws one instant or a strip of several.
ExitCode figure(const FigureOptions& options);
/// Tells whether pictures, or folders of them, are the same.
ExitCode compare(const CompareOptions& options);
/// Makes a picture again from what it carries and compares.
ExitCode reproduce(const ReproduceOptions& options);
/// Measures run time against error.
ExitCode bench(const BenchOptions& options);
/// Lists the scenes that come along, or prints the one named.
ExitCode scenes(const std::string& name);
/// Prints the JSON Schema of scenes.
ExitCode schema();

}  // namespace wuerfel
