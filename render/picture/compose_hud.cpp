// The HUD: title, time and energy at the top, scale bar and legend at the bottom, all with round
// numbers; behind each part a plate, so that nothing of the scene is seen through it.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "render/picture/frame_parts.h"
#include "render/picture/hud.h"
#include "render/picture/units.h"

namespace wuerfel::internal {
namespace {

constexpr double column_gap = 30.0;  ///< px of a 1280x720 picture, between time and energy

/// The title, shortened with an ellipsis where the picture is too narrow.
std::string fitted(const FrameParts& parts, const std::string& text, double size, double room) {
  if (parts.font.width(text, size) <= room) return text;
  std::string shorter;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t start = at;
    next_code_point(text, at);
    const std::string candidate = shorter + text.substr(start, at - start);
    if (parts.font.width(candidate + "…", size) > room) break;
    shorter = candidate;
  }
  return shorter + "…";
}

/// J, of which an energy is a difference: what is far below is the rounding of a sum.
double energy_at_work(const Snapshot& snapshot) {
  double sum = 0.0;
  for (const SnapshotBox& box : snapshot.boxes) {
    sum += box.mass
           * (std::abs(snapshot.gravity.dot(box.center)) + snapshot.gravity.norm() * box.size.norm()
              + 0.5 * box.velocity.squaredNorm());
  }
  for (const SnapshotMass& mass : snapshot.masses) {
    sum += mass.mass
           * (std::abs(snapshot.gravity.dot(mass.position)) + 0.5 * mass.velocity.squaredNorm());
  }
  return sum;
}

std::string energy_text(const Snapshot& snapshot) {
  constexpr double resolved = 1e-6;  // of changes; the error budget of states is 1e-8
  constexpr double rounding = 1e-9;
  const double work = energy_at_work(snapshot);
  const double energy = std::abs(snapshot.energy) <= rounding * work ? 0.0 : snapshot.energy;
  const double size = std::max(std::abs(energy), std::abs(snapshot.energy_start));
  std::string text = "E = " + energy_label(energy, size > rounding * work ? size : 0.0);
  const double change = snapshot.energy - snapshot.energy_start;
  if (std::abs(change) <= resolved * std::max(size, work)) return text;
  return text
         + fmt::format(" ({}{})", change > 0.0 ? "+" : "−",
                       energy_change_label(std::abs(change), size));
}

void add_head(const FrameParts& parts) {
  const double x = hud_margin * parts.unit;
  const double title = parts.style.title_size * parts.unit;
  const double size = parts.style.text_size * parts.unit;
  const double room = parts.view.width - 2.0 * x;
  HudText text(parts);
  double y = x;
  if (!parts.snapshot.title.empty()) {
    y += 0.78 * title;
    text.add(fitted(parts, parts.snapshot.title, title, room), x, y, title, parts.style.ink);
    y += 0.75 * size;
  }
  y += 0.78 * size;
  const std::string time = "t = " + time_label(parts.snapshot.time, parts.options.interval);
  if (parts.font.width(time, size) > room) return text.paint();
  text.add(time, x, y, size, parts.style.quiet_ink);
  // The place of the energy does not depend on the digits of the time, as long as there are few.
  const double column =
      std::max(parts.font.width("t = 00.000 s", size), parts.font.width(time, size))
      + column_gap * parts.unit;
  const std::string energy = energy_text(parts.snapshot);
  if (column + parts.font.width(energy, size) <= room)
    text.add(energy, x + column, y, size, parts.style.quiet_ink);
  text.paint();
}

void add_side_entries(const FrameParts& parts, LegendRow& row) {
  row.triangle("A ≥ 0", false);
  if (parts.options.legend.has(LegendEntry::negative)) row.triangle("A < 0", true);
}

void add_acceleration_entries(const FrameParts& parts, LegendRow& row) {
  const FrameOptions& options = parts.options;
  const bool force = options.layers.has(Layer::forces) || options.layers.has(Layer::contact_forces);
  row.arrow({options.metres_per_acceleration, "m/s²", ""}, parts.style.acceleration,
            ArrowForm::twice);
  if (!force && options.legend.has(LegendEntry::cut))
    row.sample("longer than shown", parts.style.acceleration, {.cut = true});
}

/// The arrows of forces: their scale, and what else is to be known of them.
void add_force_entries(const FrameParts& parts, LegendRow& row) {
  const FrameOptions& options = parts.options;
  const double scale = options.force_scale.metres_per_newton;
  const bool corners = parts.has(Layer::contact_forces);
  const bool pushes = corners || (parts.has(Layer::forces) && !is_crowd(parts.snapshot));
  const Color color = pushes ? parts.style.contact : parts.style.own_weight;
  if (!pushes) {
    row.arrow({scale, "N", "weight"}, color, ArrowForm::filled);
  } else if (corners && options.legend.has(LegendEntry::friction)) {
    row.arrow({scale, "N", "contact"}, color, ArrowForm::filled);
    row.arrow({scale, "N", "friction"}, parts.style.friction, ArrowForm::half);
  } else {
    row.arrow({scale, "N", ""}, color, ArrowForm::filled);
  }
  if (pushes && parts.has(Layer::weights)) row.sample("weight", parts.style.own_weight, {});
  if (pushes && options.legend.has(LegendEntry::several))
    row.sample("one of many possible", color, {.hollow = true});
  if (parts.has(Layer::whiskers) && options.legend.has(LegendEntry::range))
    row.whisker("from least to most", false);
  if (parts.has(Layer::whiskers) && options.legend.has(LegendEntry::beyond))
    row.whisker("and on", true);
  if (options.legend.has(LegendEntry::cut)) row.sample("longer than shown", color, {.cut = true});
  if (options.legend.has(LegendEntry::hidden))
    row.dot(fmt::format("below {}", with_prefix(least_arrow(parts), "N", 2)), color);
}

void add_rod_entries(const FrameParts& parts, LegendRow& row) {
  const double full = parts.options.full_rod_force;
  const std::string most = full > 0.0 ? fmt::format(" to {}", with_prefix(full, "N", 3)) : "";
  row.swatch("tension" + most, parts.style.tension);
  row.swatch("compression" + most, parts.style.compression);
}

void add_cause_entries(const FrameParts& parts, LegendRow& row) {
  const Legend& legend = parts.options.legend;
  if (parts.has(Layer::mechanism) && legend.has(LegendEntry::mechanism))
    row.moved_box("mechanism, not to scale", parts.style.mechanism);
  if (parts.has(Layer::causes) && legend.has(LegendEntry::cause))
    row.failing_box("fails by itself", parts.style.cause);
}

/// `arrows`: of joints.
void add_forces_and_blows(const FrameParts& parts, bool arrows, LegendRow& row) {
  if (!(parts.options.force_scale.metres_per_newton > 0.0)) return;
  const Legend& legend = parts.options.legend;
  const bool pushes = arrows || parts.has(Layer::contact_forces);
  const bool weights = parts.has(Layer::weights);
  if ((pushes && legend.has(LegendEntry::contact)) || weights) add_force_entries(parts, row);
  if ((pushes || weights) && parts.has(Layer::forces) && legend.has(LegendEntry::impact))
    row.ring("impact", parts.style.contact);
}

void add_entries(const FrameParts& parts, LegendRow& row) {
  const FrameOptions& options = parts.options;
  row.scale_bar();
  const bool arrows = parts.has(Layer::forces) && !is_crowd(parts.snapshot);
  const bool occur = options.legend.has(LegendEntry::contact);
  add_forces_and_blows(parts, arrows, row);
  if (parts.has(Layer::velocities) && options.metres_per_speed > 0.0)
    row.arrow({options.metres_per_speed, "m/s", ""}, parts.style.velocity, ArrowForm::open);
  if (parts.has(Layer::accelerations) && options.metres_per_acceleration > 0.0)
    add_acceleration_entries(parts, row);
  if (parts.has(Layer::joints) && options.force_scale.metres_per_newton > 0.0)
    row.comb("pressure", parts.style.contact);
  if (parts.has(Layer::thrust)) row.dashes("thrust", parts.style.thrust);
  if (arrows && occur && shows_paths(options))
    row.swatch("thrust", with_alpha(parts.style.ink, path_alpha));
  add_cause_entries(parts, row);
  if (parts.has(Layer::normals)) row.normal("normal");
  if (parts.has(Layer::sides)) add_side_entries(parts, row);
  if (parts.has(Layer::points) && !parts.snapshot.points.empty())
    row.dot("mass, by area", parts.style.mass);
  if (parts.has(Layer::rod_forces)) add_rod_entries(parts, row);
}

LegendRow measured_legend(const FrameParts& parts, double share) {
  LegendRow row(parts, LegendRow::Pass::measuring, share);
  add_entries(parts, row);
  return row;
}

/// Of the picture's width: the least at which no more rows hold as much.
double legend_share(const FrameParts& parts) {
  const LegendRow widest = measured_legend(parts, 1.0);
  if (widest.rows() == 1) return 1.0;
  double share = 0.5;
  const auto holds_less = [&](const LegendRow& row) {
    return row.left_out() > widest.left_out() || row.rows() > widest.rows();
  };
  while (share < 1.0 && holds_less(measured_legend(parts, share)))
    share += 0.05;
  return std::min(share, 1.0);
}

}  // namespace

void add_hud(const FrameParts& parts) {
  const HudParts hud = hud_parts(parts.style, parts.options, parts.view.width, parts.view.height);
  if (hud.head) add_head(parts);
  if (hud.head) add_color_bar(parts);
  if (hud.foot) add_legend(parts);
}

void add_legend(const FrameParts& parts) {
  const double share = legend_share(parts);
  const LegendRow measured = measured_legend(parts, share);
  measured.paint_plate();
  LegendRow row(parts, LegendRow::Pass::painting, share, measured.rows());
  add_entries(parts, row);
  parts.list.legend_left_out += row.left_out();
  parts.list.legend_rows = row.rows();
}

}  // namespace wuerfel::internal
