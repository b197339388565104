// What fits a motion: the view, the scales of arrows and colours, the height of a page, the legend.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "app/film/picture_options.h"
#include "render/picture/explode.h"

namespace wuerfel {

namespace {

constexpr double longest_velocity_arrow = 1.5;  // typical sides of a cube
constexpr double gravity_arrow = 0.4;           // likewise, of an acceleration of g
constexpr double longest_acceleration_arrow = 1.0;
constexpr double free_body_share = 0.6;  // of a joint's arrow: forces of a free body don't meet

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
      if (options.layers.has(Layer::accelerations)) {
        bounds.include(Vec2(box.center
                            + options.acceleration_scale.value_or(0.0)
                                  * shown_acceleration(box.acceleration, snapshot.gravity)));
      }
    }
  });
  for (const SnapshotBox& box : motion.besides())
    bounds.include(box);
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
    options.force_scale = {scale.metres_per_newton, scale};
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

double fitted_velocity_scale(const MotionRange& range) {
  if (!(range.fastest > 0.0)) return 0.0;
  return longest_velocity_arrow * range.forces.typical_side() / range.fastest;
}

// Accelerations are compared with that of free fall.
double fitted_acceleration_scale(const MotionRange& range) {
  const double most = range.largest_acceleration;
  if (!(most > 0.0)) return 0.0;
  const double side = range.forces.typical_side();
  if (range.gravity > 0.0) return gravity_arrow * side / range.gravity;
  return longest_acceleration_arrow * side / most;
}

}  // namespace

// What does not occur has the scale 0, which pictures carry, too: another range would not fit it.
PictureOptions fit_scales(PictureOptions options, const MotionRange& range) {
  const Layers layers = options.layers;
  if (draws_forces(layers)) fit_force_scale(options, range.forces);
  if (layers.has(Layer::velocities) && !options.velocity_scale)
    options.velocity_scale = fitted_velocity_scale(range);
  if (layers.has(Layer::accelerations) && !options.acceleration_scale)
    options.acceleration_scale = fitted_acceleration_scale(range);
  if (layers.has(Layer::rod_forces) && !options.rod_scale) options.rod_scale = range.largest_rod;
  if (!options.color_top && options.color_by == ColorBy::load)
    options.color_top = typical_top(range.loads);
  if (!options.color_top && options.color_by == ColorBy::speed) options.color_top = range.fastest;
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
    const double with_hud = height_for_hud(style, frame, width, static_cast<int>(height)) + 1.0;
    height = std::clamp(std::max(room * size.y() / size.x() + insets.top + insets.bottom, with_hud),
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
  const double top = fitted.color_top.value_or(0.0);
  if (top > 0.0 && most > top * (1.0 + 1e-9)) legend.insert(LegendEntry::above);
  if (fitted.explode > 0.0 && range.linked) legend.insert(LegendEntry::contact);
  if (fitted.layers.has(Layer::accelerations) && range.gravity > 0.0
      && range.largest_acceleration > most_gravities * range.gravity)
    legend.insert(LegendEntry::cut);
  if (!fitted.force_scale || fitted.force_scale->metres_per_newton <= 0.0) return legend;
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

}  // namespace wuerfel
