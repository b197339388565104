#include "app/film/picture_options.h"

#include <algorithm>

#include <fmt/core.h>

#include "app/cli/exit_code.h"

namespace wuerfel {

namespace {

constexpr double longest_velocity_arrow = 1.5;  // typical sides of a cube

Insets insets_of(const PictureOptions& options) {
  FrameOptions frame;
  frame.layers = options.layers;
  frame.scale = options.scale;
  return frame_insets(make_style(options.theme), frame, options.size.width, options.size.height);
}

// Everything from the first frame to the last, arrows too.
Camera fitted_camera(const PictureOptions& options, const Recording& motion) {
  const bool arrows = options.layers.has(Layer::forces) && options.force_scale;
  const ForceScale scale = arrows ? *options.force_scale->whole : ForceScale{};
  const double arrow_per_speed = options.velocity_scale.value_or(0.0);
  Bounds bounds;
  motion.for_each([&](const Snapshot& snapshot) {
    bounds.include(snapshot, scale);
    if (!options.layers.has(Layer::velocities)) return;
    for (const SnapshotBox& box : snapshot.boxes)
      bounds.include(Vec2(box.center + arrow_per_speed * box.velocity));
  });
  const View view = fit_view(bounds, options.size.width, options.size.height, insets_of(options));
  Camera camera;
  camera.kind = Camera::Kind::fixed;
  camera.center = view.center;
  camera.width = view.width / view.pixels_per_metre / options.camera.zoom;
  return camera;
}

}  // namespace

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
  return options.camera.kind == Camera::Kind::fit
         || (layers.has(Layer::forces) && !options.force_scale)
         || (layers.has(Layer::velocities) && !options.velocity_scale)
         || (layers.has(Layer::rod_forces) && !options.rod_scale);
}

PictureOptions fit_to_motion(PictureOptions options, const Recording& motion) {
  const MotionRange& range = motion.range();
  if (options.layers.has(Layer::forces)) {
    if (!options.force_scale) {
      const ForceScale scale = range.forces.scale();
      if (scale.metres_per_newton > 0.0) options.force_scale = {scale.metres_per_newton, scale};
    } else if (!options.force_scale->whole) {
      options.force_scale->whole =
          fixed_force_scale(options.force_scale->metres_per_newton, range.forces);
    }
  }
  if (options.layers.has(Layer::velocities) && !options.velocity_scale && range.fastest > 0.0)
    options.velocity_scale = longest_velocity_arrow * range.forces.typical_side() / range.fastest;
  if (options.layers.has(Layer::rod_forces) && !options.rod_scale && range.largest_rod > 0.0)
    options.rod_scale = range.largest_rod;
  if (options.camera.kind == Camera::Kind::fit) options.camera = fitted_camera(options, motion);
  return options;
}

FrameOptions frame_options(const PictureOptions& fitted) {
  FrameOptions frame;
  frame.layers = fitted.layers;
  frame.scale = fitted.scale;
  if (fitted.force_scale) frame.force_scale = fitted.force_scale->whole.value_or(ForceScale{});
  frame.metres_per_speed = fitted.velocity_scale.value_or(0.0);
  frame.full_rod_force = fitted.rod_scale.value_or(0.0);
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
  if (fitted.rod_scale) text += fmt::format(" --rod-scale {}", *fitted.rod_scale);
  return text;
}

SnapshotRequest snapshot_request(Layers layers) {
  return {.forces = layers.has(Layer::forces),
          .rods = layers.has(Layer::rods) || layers.has(Layer::rod_forces),
          .rod_forces = layers.has(Layer::rod_forces),
          .points = layers.has(Layer::points),
          .contacts = layers.has(Layer::contacts) || layers.has(Layer::normals),
          .sides = layers.has(Layer::sides)};
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
