#include "app/cli/option_groups.h"

#include <cmath>

#include "app/cli/memory_limit.h"
#include "app/cli/picture_values.h"

namespace wuerfel {

using Text = std::string;

namespace {

int parse_difference(const Text& text) {
  return static_cast<int>(parse_whole("--max-difference", text, 0, 255));
}

double parse_share(const Text& text) {
  const double value = parse_number("--max-share", text);
  if (value < 0.0 || value > 1.0)
    throw UsageError(fmt::format("--max-share: {} is not between 0 and 1", text));
  return value;
}

double parse_scale(const Text& text) {
  const double value = parse_number("--scale", text);
  require_scale("--scale", value);
  return value;
}

// Films count in millionths of a frame per second.
double parse_fps(const Text& text) {
  constexpr double smallest = 0.001;
  const double value = parse_positive("--fps", text);
  if (value < smallest) throw UsageError(fmt::format("--fps: {} is less than {}", text, smallest));
  return value;
}

// Farther apart bodies are specks, and places overflow.
double parse_explode(const Text& text) {
  constexpr double most = 1000.0;
  const double value = parse_not_negative("--explode", text);
  if (value > most) {
    throw UsageError(
        fmt::format("--explode: {} is more than {}; 0.3 shows free bodies", text, most));
  }
  return value;
}

constexpr const char* scene_meaning =
    "scene file (TOML or JSON), - for standard input, or a shipped scene";

void add_overrides(Options& options, std::vector<Text>& overrides) {
  options.value("--set", "KEY=VALUE",
                "override a key of the scene, as in cube.a.angle=0.1 (repeatable)",
                [&overrides](const Text& text) { overrides.push_back(text); });
}

int parse_threads(const char* option, const Text& text) {
  return static_cast<int>(parse_whole(option, text, 1, 1024));
}

// Less than doubles can hold takes for ever.
double parse_tolerance(const Text& text) {
  constexpr double smallest = 1e-15;
  const double value = parse_positive("--tolerance", text);
  if (value < smallest) {
    throw UsageError(
        fmt::format("--tolerance: {} is below {}, which is all that numbers of 16 digits can hold",
                    text, smallest));
  }
  return value;
}

}  // namespace

void add_memory_option(Options& options) {
  options.single("--max-memory", "SIZE", "stop where more memory is held, as 500M or 4G [no limit]",
                 [](const Text& text) { limit_memory(parse_bytes("--max-memory", text)); });
}

void add_threads_option(Options& options, int& threads, const char* what) {
  options.single("--threads", "N",
                 fmt::format("{} that are worked on at once [one per core]", what),
                 [&threads](const Text& text) { threads = parse_threads("--threads", text); });
}

void add_jobs_option(Options& options, int& threads) {
  options.single("-j,--jobs", "N", "cases that are worked on at once [one per core]",
                 [&threads](const Text& text) { threads = parse_threads("--jobs", text); });
}

void add_scene(Options& options, SceneChoice& scene) {
  options.argument("SCENE", scene_meaning, scene.source);
  add_overrides(options, scene.overrides);
}

void add_scenes(Options& options, std::vector<Text>& sources, std::vector<Text>& overrides) {
  options.arguments("SCENE",
                    Text(scene_meaning) + "; several, or - with one JSON scene a line, one by one",
                    sources);
  add_overrides(options, overrides);
}

void add_solver_options(Options& options, MotionSettings& motion) {
  add_choice(options, "--formulation", "unknowns of the program", motion.formulation);
  add_choice(options, "--solver", "who solves the program", motion.solver);
}

void add_motion_options(Options& options, MotionSettings& motion) {
  add_choice(options, "--integrator", "how time is stepped", motion.integrator);
  add_solver_options(options, motion);
  options.single("--tolerance", "TOL", "error budget of states, at least 1e-15 [1e-8]",
                 [&motion](const Text& text) { motion.tolerance = parse_tolerance(text); });
  options.single("--step", "DT",
                 "time step of rattle (at most), moreau, symplectic and euler in s [1/240]",
                 [&motion](const Text& text) { motion.step = parse_positive("--step", text); });
}

namespace {

void add_look_options(Options& options, PictureOptions& picture) {
  options.single("--size", "WxH",
                 "pixels [1280x720]; a figure takes 1280xauto: as high as the scene asks for",
                 [&picture](const Text& text) { picture.size = parse_pixel_size(text); });
  const Text layers = fmt::format("what is drawn: any of {} [{}]", join_choices(choices<Layer>()),
                                  to_string(picture.layers));
  options.single("--layers", "A,B,..", layers,
                 [&picture](const Text& text) { picture.layers = parse_layers(text); });
  options.offer("--layers", choices<Layer>());
  const Text theme =
      fmt::format("colours: {} [{}]", join_choices(choices<Theme>()), to_string(picture.theme));
  options.single("--theme", "NAME", theme,
                 [&picture](const Text& text) { picture.theme = parse_theme(text); });
  options.offer("--theme", choices<Theme>());
  add_choice(options, "--rasteriser,--rasterizer",
             "who turns shapes into pixels (they differ by rounding)", picture.rasteriser);
  options.single(
      "--force-scale", "S[,L,F]",
      "length of force arrows in m per N, of the longest in m, and the smallest force shown "
      "in N [fits the run]",
      [&picture](const Text& text) { picture.force_scale = parse_force_scale(text); });
  options.single("--velocity-scale", "S",
                 "length of velocity arrows in m per m/s, 0: none [fits the run]",
                 [&picture](const Text& text) {
                   picture.velocity_scale = parse_not_negative("--velocity-scale", text);
                 });
  options.single("--acceleration-scale", "S",
                 "length of acceleration arrows in m per m/s^2, 0: none [fits the run]",
                 [&picture](const Text& text) {
                   picture.acceleration_scale = parse_not_negative("--acceleration-scale", text);
                 });
  options.single(
      "--color,--colour", "BY",
      fmt::format("what the colours of cubes tell: {} [body; load from {} cubes on]",
                  join_choices(choices<ColorBy>()), crowd),
      [&picture](const Text& text) { picture.color_by = parse_choice<ColorBy>("--color", text); });
  options.single(
      "--color-top", "N",
      "load in N, or speed in m/s, of the last colour; 0: the largest of each picture [fits the "
      "run]",
      [&picture](const Text& text) {
        picture.color_top = parse_not_negative("--color-top", text);
      });
  options.single("--explode", "S",
                 "free bodies: each farther from the others by this share of their distance, with "
                 "all forces on it, weights and numbers [0]",
                 [&picture](const Text& text) { picture.explode = parse_explode(text); });
}

void add_camera_options(Options& options, PictureOptions& picture) {
  options.single("--legend", "A,B,..",
                 fmt::format("what the legend says of forces: any of {} [what occurs]",
                             join_choices(choices<LegendEntry>())),
                 [&picture](const Text& text) { picture.legend = parse_legend(text); });
  options.single(
      "--average", "S",
      "forces are averages over the S seconds before, impulses included; 0: those of the "
      "instant [the time between two frames]",
      [&picture](const Text& text) { picture.average = parse_time("--average", text); });
  options.single(
      "--rod-scale", "N",
      "force in N at which rods are drawn thickest, 0: the largest of each picture [fits the run]",
      [&picture](const Text& text) {
        picture.rod_scale = parse_not_negative("--rod-scale", text);
      });
  options.single(
      "--view", "fit|X,Y,WIDTH|follow:NAME",
      "part of the world: all of the motion, centre and width in m, or around a body [fit]",
      [&picture](const Text& text) {
        const double zoom = picture.camera.zoom;
        picture.camera = parse_camera(text);
        picture.camera.zoom = zoom;
      });
  options.single("--zoom", "Z", "show the view Z times larger [1]", [&picture](const Text& text) {
    picture.camera.zoom = parse_positive("--zoom", text);
  });
  options.single(
      "--scale", "S",
      "size of text, lines and arrow heads, 0.01 to 8; they grow with the picture anyway [1]",
      [&picture](const Text& text) { picture.scale = parse_scale(text); });
}

}  // namespace

void add_picture_options(Options& options, PictureOptions& picture) {
  add_look_options(options, picture);
  add_camera_options(options, picture);
}

void add_encoder_option(Options& options, PngEncoder& encoder) {
  add_choice(options, "--encoder", "who compresses PNG files (their pixels are the same)", encoder);
}

void add_rate_options(Options& options, FrameRate& rate) {
  options.single("--fps", "F", "frames per second of the film [60]",
                 [&rate](const Text& text) { rate.fps = parse_fps(text); });
  options.single("--speed", "X", "simulated time per film time, 0.1 is slow motion [1]",
                 [&rate](const Text& text) { rate.speed = parse_positive("--speed", text); });
}

void add_strip_option(Options& options, std::optional<StripGrid>& strip) {
  options.single("--strip", "COLUMNSxROWS", "several instants in one picture, as 4x2",
                 [&strip](const Text& text) { strip = parse_strip(text); });
}

void add_ghosts_option(Options& options, int& ghosts) {
  options.single("--ghosts", "N", "earlier poses of the cubes, evenly from the start, faintly [0]",
                 [&ghosts](const Text& text) {
                   static_cast<void>(parse_not_negative("--ghosts", text));
                   ghosts = static_cast<int>(parse_whole("--ghosts", text, 0, 100));
                 });
}

void add_compare_limits(Options& options, CompareLimits& limits) {
  options.single(
      "--max-difference", "N",
      "difference of a channel (0 to 255) that still counts as the same [4]",
      [&limits](const Text& text) { limits.largest_difference = parse_difference(text); });
  options.single("--max-share", "S", "share of the pixels (0 to 1) that may differ so [0.05]",
                 [&limits](const Text& text) { limits.largest_share = parse_share(text); });
}

}  // namespace wuerfel
