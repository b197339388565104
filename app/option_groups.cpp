#include "app/option_groups.h"

#include <cmath>

#include "app/picture_values.h"

namespace wuerfel {

using Text = std::string;

namespace {

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

}  // namespace

void add_scene(CLI::App& app, SceneChoice& scene) {
  app.add_option("SCENE", scene.source,
                 "scene file (TOML or JSON), - for standard input, or a shipped scene")
      ->required()
      ->type_name("");
  add_value(app, "--set", "KEY=VALUE",
            "override a key of the scene, as in cube.a.angle=0.1 (repeatable)",
            [&scene](const Text& text) { scene.overrides.push_back(text); });
}

void add_motion_options(CLI::App& app, MotionSettings& motion) {
  add_choice(app, "--integrator", "how time is stepped", motion.integrator);
  add_choice(app, "--formulation", "unknowns of the program", motion.formulation);
  add_choice(app, "--solver", "who solves the program", motion.solver);
  add_single(
      app, "--tolerance", "TOL", "error budget of states [1e-8]",
      [&motion](const Text& text) { motion.tolerance = parse_positive("--tolerance", text); });
  add_single(app, "--step", "DT",
             "time step of rattle (at most), moreau, symplectic and euler in s [1/240]",
             [&motion](const Text& text) { motion.step = parse_positive("--step", text); });
}

void add_picture_options(CLI::App& app, PictureOptions& picture) {
  add_single(app, "--size", "WxH", "pixels [1280x720]",
             [&picture](const Text& text) { picture.size = parse_pixel_size(text); });
  const Text layers = fmt::format("what is drawn: any of {} [{}]", join_choices(choices<Layer>()),
                                  to_string(picture.layers));
  add_single(app, "--layers", "A,B,..", layers,
             [&picture](const Text& text) { picture.layers = parse_layers(text); });
  const Text theme =
      fmt::format("colours: {} [{}]", join_choices(choices<Theme>()), to_string(picture.theme));
  add_single(app, "--theme", "NAME", theme,
             [&picture](const Text& text) { picture.theme = parse_theme(text); });
  add_single(app, "--force-scale", "S[,L,F]",
             "length of force arrows in m per N, of the longest in m, and the smallest force shown "
             "in N [fits the run]",
             [&picture](const Text& text) { picture.force_scale = parse_force_scale(text); });
  add_single(app, "--velocity-scale", "S", "length of velocity arrows in m per m/s [fits the run]",
             [&picture](const Text& text) {
               picture.velocity_scale = parse_positive("--velocity-scale", text);
             });
  add_single(
      app, "--rod-scale", "N", "force in N at which rods are drawn thickest [fits the run]",
      [&picture](const Text& text) { picture.rod_scale = parse_positive("--rod-scale", text); });
  add_single(app, "--view", "fit|X,Y,WIDTH|follow:NAME",
             "part of the world: all of the motion, centre and width in m, or around a body [fit]",
             [&picture](const Text& text) {
               const double zoom = picture.camera.zoom;
               picture.camera = parse_camera(text);
               picture.camera.zoom = zoom;
             });
  add_single(app, "--zoom", "Z", "show the view Z times larger [1]", [&picture](const Text& text) {
    picture.camera.zoom = parse_positive("--zoom", text);
  });
  add_single(app, "--scale", "S", "size of text, lines and arrow heads, 2 for a HiDPI screen [1]",
             [&picture](const Text& text) { picture.scale = parse_positive("--scale", text); });
}

void add_encoder_option(CLI::App& app, PngEncoder& encoder) {
  add_choice(app, "--encoder", "who compresses PNG files (their pixels are the same)", encoder);
}

void add_rate_options(CLI::App& app, FrameRate& rate) {
  add_single(app, "--fps", "F", "frames per second of the film [60]",
             [&rate](const Text& text) { rate.fps = parse_positive("--fps", text); });
  add_single(app, "--speed", "X", "simulated time per film time, 0.1 is slow motion [1]",
             [&rate](const Text& text) { rate.speed = parse_positive("--speed", text); });
}

void add_strip_option(CLI::App& app, std::optional<StripGrid>& strip) {
  add_single(app, "--strip", "COLUMNSxROWS", "several instants in one picture, as 4x2",
             [&strip](const Text& text) { strip = parse_strip(text); });
}

void add_compare_limits(CLI::App& app, CompareLimits& limits) {
  add_single(app, "--max-difference", "N",
             "difference of a channel (0 to 255) that still counts as the same [4]",
             [&limits](const Text& text) { limits.largest_difference = parse_difference(text); });
  add_single(app, "--max-share", "S", "share of the pixels (0 to 1) that may differ so [0.05]",
             [&limits](const Text& text) { limits.largest_share = parse_share(text); });
}

}  // namespace wuerfel
