#include "app/picture.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "render/draw_frame.h"

namespace wuerfel {

namespace {

constexpr double longest_velocity_arrow = 1.5;  // typical sides of a cube

}  // namespace

SnapshotRequest snapshot_request(Layers layers) {
  return {.forces = layers.has(Layer::forces),
          .rods = layers.has(Layer::rods) || layers.has(Layer::rod_forces),
          .rod_forces = layers.has(Layer::rod_forces),
          .points = layers.has(Layer::points),
          .contacts = layers.has(Layer::contacts) || layers.has(Layer::normals),
          .sides = layers.has(Layer::sides)};
}

Painter::Painter(const Recording& film, const PictureOptions& options)
    : film_(film), options_(options), style_(make_style(options.theme)) {
  frame_.layers = options.layers;
  fit_arrows();
  view_ = fit();
}

void Painter::fit_arrows() {
  ForceRange forces;
  double fastest = 0.0;
  bool friction = false;
  for (std::size_t k = 0; k < film_.size(); ++k) {
    const Snapshot snapshot = film_.frame(k);
    forces.include(snapshot);
    for (const SnapshotBox& box : snapshot.boxes)
      fastest = std::max(fastest, box.velocity.norm());
    for (const SnapshotRod& rod : snapshot.rods) {
      frame_.full_rod_force = std::max(frame_.full_rod_force, std::abs(rod.tension));
    }
    friction = friction || std::ranges::any_of(snapshot.forces, [](const SnapshotForce& force) {
                 return force.kind == ForceKind::friction;
               });
  }
  frame_.force_scale =
      options_.force_scale ? fixed_force_scale(*options_.force_scale, forces) : forces.scale();
  if (fastest > 0.0)
    frame_.metres_per_speed = longest_velocity_arrow * forces.typical_side() / fastest;
  if (friction) frame_.legend.push_back(ForceKind::friction);
  if (options_.layers.has(Layer::rod_forces)) {
    frame_.legend.push_back(ForceKind::rod_tension);
    frame_.legend.push_back(ForceKind::rod_compression);
  }
}

View Painter::fit() const {
  const auto [width, height] = options_.size;
  if (options_.view != "fit") return parse_view(options_.view, width, height);
  const ForceScale scale = options_.layers.has(Layer::forces) ? frame_.force_scale : ForceScale{};
  Bounds bounds;
  for (std::size_t k = 0; k < film_.size(); ++k) {
    bounds.include(film_.frame(k), scale);
  }
  return fit_view(bounds, width, height, frame_insets(style_, frame_, width, height));
}

const Image& Painter::draw(std::size_t k) {
  Snapshot snapshot = film_.frame(k);
  // The clock of the HUD runs even where nothing moves.
  const bool same =
      drawn_ && snapshot.revision == drawn_revision_ && !options_.layers.has(Layer::hud);
  if (same) {
    ++reused_;
    return image_;
  }
  if (options_.layers.has(Layer::trails)) snapshot.trails = film_.trails(k);
  draw_frame(renderer_, snapshot, view_, style_, frame_, image_);
  drawn_ = true;
  drawn_revision_ = snapshot.revision;
  return image_;
}

std::string Painter::option_text() const {
  std::string text =
      fmt::format("--size {}x{} --layers {} --theme {} --view {},{},{}", options_.size.width,
                  options_.size.height, to_string(options_.layers), to_string(options_.theme),
                  view_.center.x(), view_.center.y(), view_.width / view_.pixels_per_metre);
  if (frame_.force_scale.metres_per_newton > 0.0) {
    text += fmt::format(" --force-scale {}", frame_.force_scale.metres_per_newton);
  }
  return text;
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

std::vector<PngText> origin(double time,
                            const std::string& options,
                            const std::string& normalised_scene) {
  return {{"Software", "wuerfel " WUERFEL_VERSION},
          {"Simulated time", fmt::format("{}", time)},
          {"Options", options},
          {"Scene", normalised_scene}};
}

std::string option_text(const MotionSettings& motion) {
  return fmt::format("--integrator {} --formulation {} --solver {} --tolerance {} --step {}",
                     to_string(motion.integrator), to_string(motion.formulation),
                     to_string(motion.solver), motion.tolerance, motion.step);
}

}  // namespace wuerfel
