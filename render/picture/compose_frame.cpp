#include "render/picture/compose_frame.h"

#include <algorithm>
#include <cmath>

#include "render/picture/frame_parts.h"

namespace wuerfel {
namespace {

constexpr double smallest_unit = 0.62;  ///< text of 9 px is the smallest that can be read
constexpr double full_weight_side =
    44;  ///< px of a 1280x720 picture: cubes of this size bear full line weights
constexpr double smallest_fineness = 0.4;

/// Line weights shrink with the cubes below a certain size.
double fineness(const Snapshot& snapshot, const View& view, double unit) {
  double sum = 0.0;
  int count = 0;
  for (const SnapshotBox& box : snapshot.boxes) {
    if (box.fixed) continue;
    sum += std::min(box.size.x(), box.size.y());
    ++count;
  }
  if (count == 0) return 1.0;
  const double side = sum / count * view.pixels_per_metre / unit;
  return std::clamp(side / full_weight_side, smallest_fineness, 1.0);
}

}  // namespace

double frame_unit(int width, int height, double scale) {
  const double area = static_cast<double>(width) * height / (1280.0 * 720.0);
  return scale * std::max(std::sqrt(area), smallest_unit);
}

Insets frame_insets(const Style& style, const FrameOptions& options, int width, int height) {
  const double unit = frame_unit(width, height, options.scale);
  const double margin = 30.0 * unit;
  if (!options.layers.has(Layer::hud)) return {margin, margin, margin, margin};
  return {margin, (40.0 + style.title_size + style.text_size) * unit, margin,
          (44.0 + style.text_size) * unit};
}

DrawList compose_frame(const Snapshot& snapshot,
                       const View& view,
                       const Style& style,
                       const FrameOptions& options,
                       Font& font) {
  DrawList list;
  list.width = view.width;
  list.height = view.height;
  list.background = style.background;
  const double unit = frame_unit(view.width, view.height, options.scale);
  const internal::FrameParts parts{
      snapshot, view, style, options, unit, fineness(snapshot, view, unit), font, list};
  if (parts.has(Layer::grid)) add_grid(parts);
  if (parts.has(Layer::cubes)) add_ground(parts);
  if (parts.has(Layer::trails)) add_trails(parts);
  if (parts.has(Layer::cubes)) add_bodies(parts);
  if (parts.has(Layer::sides)) add_sides(parts);
  if (parts.has(Layer::rods)) add_rods(parts);
  if (parts.has(Layer::rod_forces)) add_rod_forces(parts);
  if (parts.has(Layer::points)) add_points(parts);
  if (parts.has(Layer::contacts)) add_contacts(parts);
  add_arrows(parts);
  if (parts.has(Layer::names)) add_names(parts);
  if (parts.has(Layer::hud)) add_hud(parts);
  return list;
}

}  // namespace wuerfel
