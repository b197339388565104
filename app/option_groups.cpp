#include "app/option_groups.h"

#include "render/view.h"

namespace wuerfel {

using Text = std::string;

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
  add_single(app, "--step", "DT", "time step in s [1/240]",
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
  add_single(app, "--force-scale", "M/N", "length of force arrows in m per N [fits the run]",
             [&picture](const Text& text) {
               picture.force_scale = parse_positive("--force-scale", text);
             });
  add_single(app, "--view", "fit|X,Y,WIDTH", "part of the world in m: centre and width [fit]",
             [&picture](const Text& text) {
               if (text != "fit") parse_view(text, picture.size.width, picture.size.height);
               picture.view = text;
             });
}

}  // namespace wuerfel
