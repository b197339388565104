#include "app/film/picture_options.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "app/cli/exit_code.h"
#include "render/picture/explode.h"

namespace wuerfel {

namespace {

constexpr double longest_velocity_arrow = 1.5;  // typical sides of a cube
constexpr double gravity_arrow = 0.4;           // likewise, of an acceleration of g
constexpr double longest_acceleration_arrow = 1.0;
constexpr double free_body_share = 0.6;  // of a joint's arrow: forces of a free body don't meet
constexpr double impact_memory = 0.15;   // s of the film
constexpr double load_memory = 0.15;     // likewise

bool draws_forces(Layers layers) {
  return layers.has(Layer::forces) || layers.has(Layer::contact_forces) || layers.has(Layer::joints)
         || layers.has(Layer::weights);
}

bool shows_joints(Layers layers, ColorBy by) {
  return layers.has(Layer::forces) || layers.has(Layer::joints) || layers.has(Layer::thrust)
         || by == ColorBy::load || by == ColorBy::island;
}

bool marks_reasons(Layers layers) {
  return layers.has(Layer::causes) || layers.has(Layer::mechanism);
}

// Everything from the first frame to the last, arrows too.
Bounds bounds_of(const PictureOptions& options, const Recording& motion) {
  const bool arrows = draws_forces(options.layers) && options.force_scale;
  const ForceScale scale = arrows ? *options.force_scale->whole : ForceScale{};
  Bounds bounds;
  motion.for_each([&](const Snapshot& snapshot) {
    bounds.include(options.explode > 0.0 ? exploded(snapshot, options.explode) : snapshot, scale);
    const double speed = options.velocity_scale.value_or(0.0);
    for (const SnapshotContact& contact : snapshot.contacts) {
      if (!options.layers.has(Layer::velocities) || !options.layers.has(Layer::symbols)) break;
      bounds.include(Vec2(contact.p_i + speed * contact.v_i));
      bounds.include(Vec2(contact.p_j + speed * contact.v_j));
      bounds.include(Vec2(contact.p_k + speed * contact.v_k));
    }
    for (const SnapshotBox& box : snapshot.boxes) {
      if (options.layers.has(Layer::velocities))
        bounds.include(Vec2(box.center + speed * box.velocity));
      if (options.layers.has(Layer::accelerations))
        bounds.include(Vec2(box.center
                            + options.acceleration_scale.value_or(0.0)
                                  * shown_acceleration(box.acceleration, snapshot.gravity)));
    }
  });
  return bounds;
}

Camera fitted_camera(const PictureOptions& options, const Recording& motion) {
  const auto [width, height] = options.size;
  const Insets insets =
      frame_insets(make_style(options.theme), frame_options(options), width, height);
  const View view = fit_view(bounds_of(options, motion), width, height, insets);
  Camera camera;
  camera.kind = Camera::Kind::fixed;
  camera.center = view.center;
  camera.width = view.width / view.pixels_per_metre / options.camera.zoom;
  return camera;
}

void fit_force_scale(PictureOptions& options, const ForceRange& range) {
  if (!options.force_scale) {
    ForceScale scale = range.scale();
    if (options.explode > 0.0) {
      scale.metres_per_newton *= free_body_share;
      scale.longest *= free_body_share;
    }
    if (scale.metres_per_newton > 0.0) options.force_scale = {scale.metres_per_newton, scale};
  } else if (!options.force_scale->whole) {
    options.force_scale->whole = fixed_force_scale(options.force_scale->metres_per_newton, range);
  }
}

// N, of the last colour: the largest load, or where that is a rare peak, what is not.
double typical_top(const ForceRange& loads) {
  constexpr double not_much_more = 1.25;
  const double largest = loads.largest();
  const double ordinary = loads.ordinary();
  return largest > not_much_more * ordinary ? ordinary : largest;
}

// Accelerations are compared with that of free fall.
std::optional<double> fitted_acceleration_scale(const MotionRange& range) {
  const double most = range.largest_acceleration;
  if (!(most > 0.0)) return std::nullopt;
  const double side = range.forces.typical_side();
  if (range.gravity > 0.0) return gravity_arrow * side / range.gravity;
  return longest_acceleration_arrow * side / most;
}

}  // namespace

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
  if ((numbers.size() != 1 && numbers.size() != 3) || numbers[0] <= 0.0 || !positive) {
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

PictureOptions fit_scales(PictureOptions options, const MotionRange& range) {
  const Layers layers = options.layers;
  if (draws_forces(layers)) fit_force_scale(options, range.forces);
  if (layers.has(Layer::velocities) && !options.velocity_scale && range.fastest > 0.0)
    options.velocity_scale = longest_velocity_arrow * range.forces.typical_side() / range.fastest;
  if (layers.has(Layer::accelerations) && !options.acceleration_scale)
    options.acceleration_scale = fitted_acceleration_scale(range);
  if (layers.has(Layer::rod_forces) && !options.rod_scale && range.largest_rod > 0.0)
    options.rod_scale = range.largest_rod;
  if (!options.color_top && options.color_by == ColorBy::load && range.loads.largest() > 0.0)
    options.color_top = typical_top(range.loads);
  if (!options.color_top && options.color_by == ColorBy::speed && range.fastest > 0.0)
    options.color_top = range.fastest;
  return options;
}

PictureOptions fit_to_motion(PictureOptions options, const Recording& motion) {
  PictureOptions fitted = fit_scales(std::move(options), motion.range());
  if (fitted.camera.kind == Camera::Kind::fit) fitted.camera = fitted_camera(fitted, motion);
  return fitted;
}

// Text and margins grow with the picture, so that the height is found step by step.
int auto_height(const PictureOptions& scaled, const Recording& motion) {
  const int width = scaled.size.width;
  const Vec2 size = bounds_of(scaled, motion).size();
  const Style style = make_style(scaled.theme);
  const FrameOptions frame = frame_options(scaled);
  double height = 0.5625 * width;
  if (scaled.camera.kind != Camera::Kind::fit || !(size.x() > 0.0)) return static_cast<int>(height);
  for (int k = 0; k < 8; ++k) {
    const Insets insets = frame_insets(style, frame, width, static_cast<int>(height));
    const double room = std::max(width - insets.left - insets.right, 0.25 * width);
    height = std::clamp(room * size.y() / size.x() + insets.top + insets.bottom,
                        least_auto_height * width, largest_auto_height * width);
  }
  return std::max(static_cast<int>(std::lround(height)), 16);
}

Legend legend_of(const PictureOptions& fitted, const MotionRange& range) {
  if (fitted.legend) return *fitted.legend;
  Legend legend = range.seen;
  const double most = fitted.color_by == ColorBy::load    ? range.largest_load
                      : fitted.color_by == ColorBy::speed ? range.fastest
                                                          : 0.0;
  if (fitted.color_top && most > *fitted.color_top * (1.0 + 1e-9))
    legend.insert(LegendEntry::above);
  legend.insert(LegendEntry::contact);
  if (fitted.layers.has(Layer::accelerations) && range.gravity > 0.0
      && range.largest_acceleration > most_gravities * range.gravity)
    legend.insert(LegendEntry::cut);
  if (!fitted.force_scale) return legend;
  const ForceScale& scale = *fitted.force_scale->whole;
  if (range.forces.cuts(scale)) legend.insert(LegendEntry::cut);
  if (scale.cuts(range.most_possible)) legend.insert(LegendEntry::beyond);
  // Dots stand for arrows of less than some pixels.
  const double ppm = fitted.size.width / fitted.camera.width * fitted.camera.zoom;
  const double unit = frame_unit(fitted.size.width, fitted.size.height, fitted.scale);
  const double least =
      std::max(scale.hidden_below, shortest_force_arrow * unit / (scale.metres_per_newton * ppm));
  const double smallest = range.forces.smallest();
  if (smallest > 0.0 && smallest < least) legend.insert(LegendEntry::hidden);
  return legend;
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
  frame.foot_lines = fitted.foot_lines;
  frame.interval = fitted.average.value_or(0.0);
  return frame;
}

View view_of(const PictureOptions& fitted, const Snapshot& snapshot) {
  return camera_view(fitted.camera, snapshot, fitted.size.width, fitted.size.height);
}

std::string option_text(const PictureOptions& fitted) {
  std::string text =
      fmt::format("--size {}x{} --layers {} --theme {} {}", fitted.size.width, fitted.size.height,
                  to_string(fitted.layers), to_string(fitted.theme), option_text(fitted.camera));
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
  if (fitted.legend) text += fmt::format(" --legend {}", to_string(*fitted.legend));
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
