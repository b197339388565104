#include "app/film/picture_options.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "app/cli/exit_code.h"
#include "app/cli/options.h"

namespace wuerfel {

namespace {

constexpr double impact_memory = 0.15;  // s of the film
constexpr double load_memory = 0.15;    // likewise

bool shows_joints(Layers layers, ColorBy by) {
  return layers.has(Layer::forces) || layers.has(Layer::joints) || layers.has(Layer::thrust)
         || by == ColorBy::load || by == ColorBy::island;
}

bool marks_reasons(Layers layers) {
  return layers.has(Layer::causes) || layers.has(Layer::mechanism);
}

// None of them is a word too.
std::string names_text(const std::string& names) {
  return names.empty() ? quoted_word(names) : names;
}

}  // namespace

bool draws_forces(Layers layers) {
  return layers.has(Layer::forces) || layers.has(Layer::contact_forces) || layers.has(Layer::joints)
         || layers.has(Layer::weights);
}

std::string_view to_string(Fit fit) {
  switch (fit) {
    case Fit::motion:
      return "motion";
    case Fit::instant:
      return "instant";
  }
  return "?";
}

Layers drawn_layers(const PictureOptions& options, bool asked) {
  Layers layers = options.layers;
  if (asked || !(options.explode > 0.0)) return layers;
  layers.insert(Layer::weights);
  layers.insert(Layer::values);
  return layers;
}

ForceScaleChoice parse_force_scale(std::string_view text) {
  const std::vector<double> numbers = parse_numbers("--force-scale", text);
  const bool positive = std::ranges::all_of(numbers, [](double v) { return v >= 0.0; });
  // Pictures without a force have the scale 0.
  if (!positive || (numbers.size() != 3 && (numbers.size() != 1 || numbers[0] <= 0.0))) {
    throw UsageError(fmt::format(
        "--force-scale: '{}' is neither a length in m per N greater than 0, as 0.05, nor that with "
        "the longest arrow in m and the smallest force in N, as 0.05,2,0.1",
        text));
  }
  if (numbers.size() == 1) return {numbers[0], std::nullopt};
  return {numbers[0], ForceScale{numbers[0], numbers[1], numbers[2]}};
}

bool needs_whole_motion(const PictureOptions& options) {
  const Layers layers = options.layers;
  const bool scaled = options.color_by == ColorBy::load || options.color_by == ColorBy::speed;
  return options.camera.kind == Camera::Kind::fit || (draws_forces(layers) && !options.force_scale)
         || ((draws_forces(layers) || marks_reasons(layers) || layers.has(Layer::sides) || scaled)
             && !options.legend)
         || (layers.has(Layer::velocities) && !options.velocity_scale)
         || (layers.has(Layer::accelerations) && !options.acceleration_scale)
         || (layers.has(Layer::rod_forces) && !options.rod_scale) || (scaled && !options.color_top);
}

bool needs_every_force(const PictureOptions& options) {
  const Layers layers = options.layers;
  return options.explode > 0.0 || layers.has(Layer::mechanism) || layers.has(Layer::contact_forces)
         || layers.has(Layer::rod_forces) || layers.has(Layer::accelerations)
         || (layers.has(Layer::velocities) && layers.has(Layer::symbols));
}

ColorBy color_by(const PictureOptions& options, std::size_t cubes) {
  const bool loads = cubes >= crowd && options.layers.has(Layer::forces);
  return options.color_by.value_or(loads ? ColorBy::load : ColorBy::body);
}

FrameOptions frame_options(const PictureOptions& fitted) {
  FrameOptions frame;
  frame.layers = fitted.layers;
  frame.scale = fitted.scale;
  if (fitted.force_scale) frame.force_scale = fitted.force_scale->whole.value_or(ForceScale{});
  frame.metres_per_speed = fitted.velocity_scale.value_or(0.0);
  frame.metres_per_acceleration = fitted.acceleration_scale.value_or(0.0);
  frame.full_rod_force = fitted.rod_scale.value_or(0.0);
  frame.coloring = {fitted.color_by.value_or(ColorBy::body), fitted.color_top.value_or(0.0)};
  frame.legend = fitted.legend.value_or(frame.legend);
  frame.explode = fitted.explode;
  frame.head_lines = fitted.head_lines;
  frame.foot_lines = fitted.foot_lines;
  frame.interval = fitted.average.value_or(0.0);
  return frame;
}

View view_of(const PictureOptions& fitted, const Snapshot& snapshot) {
  return camera_view(fitted.camera, snapshot, fitted.size.width, fitted.size.height);
}

std::string option_text(const PictureOptions& fitted) {
  std::string text = fmt::format("--size {}x{} --layers {} --theme {} {}", fitted.size.width,
                                 fitted.size.height, names_text(to_string(fitted.layers)),
                                 to_string(fitted.theme), option_text(fitted.camera));
  if (fitted.rasteriser != PictureOptions{}.rasteriser)
    text += fmt::format(" --rasteriser {}", to_string(fitted.rasteriser));
  if (fitted.scale != 1.0) text += fmt::format(" --scale {}", fitted.scale);
  if (fitted.force_scale && fitted.force_scale->whole) {
    const ForceScale& scale = *fitted.force_scale->whole;
    text += fmt::format(" --force-scale {},{},{}", scale.metres_per_newton, scale.longest,
                        scale.hidden_below);
  }
  if (fitted.velocity_scale) text += fmt::format(" --velocity-scale {}", *fitted.velocity_scale);
  if (fitted.acceleration_scale)
    text += fmt::format(" --acceleration-scale {}", *fitted.acceleration_scale);
  if (fitted.rod_scale) text += fmt::format(" --rod-scale {}", *fitted.rod_scale);
  if (fitted.color_by) text += fmt::format(" --color {}", to_string(*fitted.color_by));
  if (fitted.color_top) text += fmt::format(" --color-top {}", *fitted.color_top);
  if (fitted.legend) text += " --legend " + names_text(to_string(*fitted.legend));
  if (fitted.explode > 0.0) text += fmt::format(" --explode {}", fitted.explode);
  if (fitted.average) text += fmt::format(" --average {}", *fitted.average);
  return text;
}

SnapshotRequest snapshot_request(const PictureOptions& options, std::size_t cubes) {
  const Layers layers = options.layers;
  const ColorBy by = color_by(options, cubes);
  const bool joints = shows_joints(layers, by);
  const bool forces = layers.has(Layer::contact_forces);
  const bool unique = (forces || layers.has(Layer::forces)) && cubes < crowd;
  return {.forces = forces,
          .joints = joints,
          .unique = unique,
          .ranges = unique && layers.has(Layer::whiskers),
          .causes = layers.has(Layer::causes),
          .mechanism = layers.has(Layer::mechanism),
          .accelerations = layers.has(Layer::accelerations),
          .rods = layers.has(Layer::rods) || layers.has(Layer::rod_forces),
          .rod_forces = layers.has(Layer::rod_forces),
          .points = layers.has(Layer::points),
          .contacts = layers.has(Layer::contacts) || layers.has(Layer::normals)
                      || layers.has(Layer::symbols),
          .sides = layers.has(Layer::sides)};
}

LookBack look_back(const PictureOptions& options, double interval, double speed) {
  const bool arrows = options.layers.has(Layer::forces);
  const double average = shows_joints(options.layers, options.color_by.value_or(ColorBy::body))
                             ? options.average.value_or(interval)
                             : 0.0;
  return {average, arrows ? impact_memory * speed : 0.0,
          options.color_by == ColorBy::load && average > 0.0 ? load_memory * speed : 0.0};
}

AnimationSettings animation_settings(const PictureOptions& options,
                                     double fps,
                                     const Scene& scene) {
  std::vector<Color> bodies;
  for (const SceneCube& cube : scene.cubes) {
    if (cube.color) bodies.push_back({(*cube.color)[0], (*cube.color)[1], (*cube.color)[2]});
  }
  return {.width = options.size.width,
          .height = options.size.height,
          .fps = fps,
          .transparent = options.theme == Theme::transparent,
          .palette = animation_palette(make_style(options.theme), bodies)};
}

}  // namespace wuerfel
