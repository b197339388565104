#include "render/picture/compose_frame.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>

#include "render/picture/explode.h"
#include "render/picture/marks.h"

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
    sum += typical_side_of(box);
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

bool shows_paths(const FrameOptions& options) {
  return options.force_scale.metres_per_newton > 0.0 && !options.layers.has(Layer::thrust);
}

Vec2 shown_acceleration(const Vec2& acceleration, const Vec2& gravity) {
  const double most = most_gravities * gravity.norm();
  const double size = acceleration.norm();
  return most > 0.0 && size > most ? Vec2(most / size * acceleration) : acceleration;
}

bool is_crowd(const Snapshot& snapshot) {
  return std::ranges::count(snapshot.boxes, false, &SnapshotBox::fixed) >= crowd;
}

namespace {

/// Each body in a colour that is its number, from 1 on in the order of the scene, cubes before fixed
/// boxes: red + 256 green + 65536 blue; 0 where there is none.
DrawList instances(const Snapshot& snapshot, const View& view) {
  DrawList list;
  list.width = view.width;
  list.height = view.height;
  list.background = rgb(0x000000);
  list.exact = true;
  for (int i = 0; i < std::ssize(snapshot.boxes); ++i) {
    const SnapshotBox& box = snapshot.boxes[i];
    const auto id = static_cast<std::uint32_t>(i + 1);
    BoxShape shape = internal::box_shape(view, box);
    shape.fill = {static_cast<std::uint8_t>(id), static_cast<std::uint8_t>(id >> 8U),
                  static_cast<std::uint8_t>(id >> 16U), 255};
    list.bodies.push_back({list.boxes.size(), i});
    list.add(shape);
  }
  return list;
}

double head_height(const Style& style, int lines, double unit) {
  return (40.0 + style.title_size + style.text_size + (lines - 1) * line_height * style.text_size)
         * unit;
}

double foot_height(const Style& style, int lines, double unit) {
  return (44.0 + style.text_size + (lines - 1) * line_height * style.text_size) * unit;
}

/// Of a picture's height, that the HUD may take: more where larger text was asked for.
double hud_share(const FrameOptions& options) { return options.scale > 1.0 ? 0.6 : 0.4; }

/// What is drawn of bodies that are apart already: their forces act on each by itself.
FrameOptions cut_free(const FrameOptions& options) {
  FrameOptions apart = options;
  apart.explode = 0.0;
  if (options.layers.has(Layer::forces)) apart.layers.insert(Layer::contact_forces);
  apart.layers.erase(Layer::forces);
  return apart;
}

/// A part of a picture that is a group of its own, and whether it is shown.
struct Part {
  std::string_view name;
  void (*add)(const internal::FrameParts&);
  bool (*shows)(const internal::FrameParts&);
};

template <Layer layer>
bool has(const internal::FrameParts& parts) {
  return parts.has(layer);
}

bool has_ghosts(const internal::FrameParts& parts) { return !parts.snapshot.ghosts.empty(); }

bool has_links(const internal::FrameParts& parts) {
  return parts.has(Layer::cubes) || parts.has(Layer::rods) || parts.has(Layer::rod_forces);
}

bool has_paths(const internal::FrameParts& parts) {
  return parts.has(Layer::forces) && !is_crowd(parts.snapshot) && shows_paths(parts.options);
}

bool has_chains(const internal::FrameParts& parts) {
  return parts.has(Layer::forces) && is_crowd(parts.snapshot);
}

bool has_fixes(const internal::FrameParts& parts) { return parts.snapshot.reason.has_value(); }

bool has_reason_text(const internal::FrameParts& parts) {
  return has_fixes(parts) && parts.has(Layer::hud);
}

bool has_hud(const internal::FrameParts& parts) {
  return !has_fixes(parts) && parts.has(Layer::hud);
}

constexpr Part below_arrows[] = {
    {"grid", internal::add_grid, has<Layer::grid>},
    {"ground", internal::add_ground, has<Layer::cubes>},
    {"trails", internal::add_trails, has<Layer::trails>},
    {"ghosts", internal::add_ghosts, has_ghosts},
    {"bodies", internal::add_bodies, has<Layer::cubes>},
    {"sides", internal::add_sides, has<Layer::sides>},
    {"rods", internal::add_rods, has<Layer::rods>},
    {"rod-forces", internal::add_rod_forces, has<Layer::rod_forces>},
    {"links", internal::add_links, has_links},
    {"pressure", internal::add_pressure, has<Layer::joints>},
    {"paths", internal::add_paths, has_paths},
    {"thrust", internal::add_thrust, has<Layer::thrust>},
    {"chains", internal::add_chains, has_chains},
    {"impacts", internal::add_impacts, has<Layer::forces>},
};

constexpr Part above_arrows[] = {
    {"whiskers", internal::add_whiskers, has<Layer::whiskers>},
    {"normals", internal::add_normals, has<Layer::normals>},
    {"contacts", internal::add_contacts, has<Layer::contacts>},
    {"points", internal::add_points, has<Layer::points>},
    {"moves", internal::add_moved_boxes, has_fixes},
    {"mechanism", internal::add_mechanism, has<Layer::mechanism>},
    {"causes", internal::add_causes, has<Layer::causes>},
    {"fixes", internal::add_fixes, has_fixes},
    {"words", internal::add_reason_text, has_reason_text},
    {"hud", internal::add_hud, has_hud},
};

constexpr Part symbols[] = {{"symbols", internal::add_symbols, has<Layer::symbols>}};

void add(std::span<const Part> all, const internal::FrameParts& parts) {
  for (const Part& part : all) {
    if (!part.shows(parts)) continue;
    parts.list.begin_group(part.name);
    part.add(parts);
  }
}

}  // namespace

HudParts hud_parts(const Style& style, const FrameOptions& options, int width, int height) {
  if (!options.layers.has(Layer::hud)) return {};
  const double unit = frame_unit(width, height, options.scale);
  const double room = hud_share(options) * height;
  return {head_height(style, 1, unit) <= room,
          height_for_hud(style, options, width, height) <= height};
}

double height_for_hud(const Style& style, const FrameOptions& options, int width, int height) {
  if (!options.layers.has(Layer::hud)) return 0.0;
  const double unit = frame_unit(width, height, options.scale);
  return (head_height(style, 1, unit) + foot_height(style, 1, unit)) / hud_share(options);
}

Insets frame_insets(const Style& style, const FrameOptions& options, int width, int height) {
  const double unit = frame_unit(width, height, options.scale);
  const double margin = std::min(30.0 * unit, 0.1 * std::min(width, height));
  const HudParts hud = hud_parts(style, options, width, height);
  const bool bar =
      hud.head && (options.coloring.by == ColorBy::load || options.coloring.by == ColorBy::speed);
  return {margin, hud.head ? head_height(style, options.head_lines, unit) : margin,
          bar ? (color_bar_width + 30.0) * unit : margin,
          hud.foot ? foot_height(style, options.foot_lines, unit) : margin};
}

DrawList compose_frame(const Snapshot& snapshot,
                       const View& view,
                       const Style& style,
                       const FrameOptions& options,
                       Font& font) {
  if (options.layers.has(Layer::instances)) return instances(snapshot, view);
  if (options.explode > 0.0)
    return compose_frame(exploded(snapshot, options.explode), view, style, cut_free(options), font);
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
  add(below_arrows, parts);
  list.begin_group("arrows");
  const std::vector<internal::PendingArrow> arrows = add_arrows(parts);
  add(above_arrows, parts);
  // Texts look for places that are still free.
  if (parts.has(Layer::values) || parts.has(Layer::joints)) add_values(parts, arrows);
  if (parts.has(Layer::values) && options.force_scale.metres_per_newton > 0.0)
    add_dot_values(parts);
  if (parts.has(Layer::joints) && !parts.has(Layer::forces)) add_joint_values(parts);
  add(symbols, parts);
  if (parts.has(Layer::names)) {
    add_names(parts);
    add_mass_names(parts);
  }
  return list;
}

DrawList compose_legend(const Snapshot& snapshot,
                        const View& view,
                        double unit,
                        const Style& style,
                        const FrameOptions& options,
                        Font& font) {
  if (options.explode > 0.0)
    return compose_legend(snapshot, view, unit, style, cut_free(options), font);
  DrawList list;
  list.width = view.width;
  list.height = view.height;
  list.background = style.background;
  internal::Labels labels(view.width, view.height);
  const internal::FrameParts parts{
      snapshot, view, style, options, unit, fineness(snapshot, view, unit), {}, font, labels, list};
  internal::add_legend(parts);
  return list;
}

}  // namespace wuerfel
