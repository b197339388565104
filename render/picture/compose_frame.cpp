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
    sum += std::sqrt(box.size.x() * box.size.y());
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

bool is_crowd(const Snapshot& snapshot) {
  return std::ranges::count(snapshot.boxes, false, &SnapshotBox::fixed) >= crowd;
}

namespace {

double head_height(const Style& style, double unit) {
  return (40.0 + style.title_size + style.text_size) * unit;
}

double foot_height(const Style& style, double unit) { return (44.0 + style.text_size) * unit; }

}  // namespace

HudParts hud_parts(const Style& style, const FrameOptions& options, int width, int height) {
  if (!options.layers.has(Layer::hud)) return {};
  constexpr double share = 0.4;
  const double unit = frame_unit(width, height, options.scale);
  const double room = share * height;
  const bool foot = head_height(style, unit) + foot_height(style, unit) <= room;
  return {head_height(style, unit) <= room, foot};
}

Insets frame_insets(const Style& style, const FrameOptions& options, int width, int height) {
  const double unit = frame_unit(width, height, options.scale);
  const double margin = std::min(30.0 * unit, 0.1 * std::min(width, height));
  const HudParts hud = hud_parts(style, options, width, height);
  const bool bar =
      hud.head && (options.coloring.by == ColorBy::load || options.coloring.by == ColorBy::speed);
  return {margin, hud.head ? head_height(style, unit) : margin,
          bar ? (color_bar_width + 30.0) * unit : margin,
          hud.foot ? foot_height(style, unit) : margin};
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
  internal::Labels labels(view.width, view.height);
  const internal::FrameParts parts{snapshot,
                                   view,
                                   style,
                                   options,
                                   unit,
                                   fineness(snapshot, view, unit),
                                   body_colors(snapshot, style, options.coloring),
                                   font,
                                   labels,
                                   list};
  if (parts.has(Layer::grid)) add_grid(parts);
  if (parts.has(Layer::cubes)) add_ground(parts);
  if (parts.has(Layer::trails)) add_trails(parts);
  if (parts.has(Layer::cubes)) add_bodies(parts);
  if (parts.has(Layer::sides)) add_sides(parts);
  if (parts.has(Layer::rods)) add_rods(parts);
  if (parts.has(Layer::rod_forces)) add_rod_forces(parts);
  const bool shows_bodies = parts.has(Layer::cubes);
  if (shows_bodies || parts.has(Layer::rods) || parts.has(Layer::rod_forces)) add_links(parts);
  if (parts.has(Layer::joints)) add_pressure(parts);
  if (parts.has(Layer::thrust)) add_thrust(parts);
  if (parts.has(Layer::normals)) add_normals(parts);
  if (parts.has(Layer::forces) && is_crowd(snapshot)) add_chains(parts);
  if (parts.has(Layer::forces)) add_impacts(parts);
  const std::vector<internal::PendingArrow> arrows = add_arrows(parts);
  if (parts.has(Layer::contacts)) add_contacts(parts);
  if (parts.has(Layer::points)) add_points(parts);
  if (parts.has(Layer::hud)) add_hud(parts);
  // Texts look for places that are still free.
  if (parts.has(Layer::values) || parts.has(Layer::joints)) add_values(parts, arrows);
  if (parts.has(Layer::names)) add_names(parts);
  return list;
}

}  // namespace wuerfel
