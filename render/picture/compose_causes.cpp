// What fails by itself: the part, the corner that it tips over, how far its centre of mass is beside
// it; and the motion that proves that nothing holds it.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "render/picture/marks.h"
#include "render/picture/units.h"

namespace wuerfel::internal {
namespace {

// Pixels of a 1280x720 picture.
constexpr double part_outline = 4.5;
constexpr double moved_outline = 2.4;
constexpr double centre_radius = 6.5;
constexpr double corner_radius = 5.5;
constexpr double lever_width = 5.0;
constexpr double plumb_width = 2.0;

std::string lever_label(const SnapshotCause& cause) {
  return cause.label.empty() ? with_prefix(cause.outside, "m", 3) : cause.label;
}

/// From its centre to the ground beside the corner that does not carry it.
void add_lever(const FrameParts& parts, const SnapshotCause& cause) {
  const Color color = parts.style.cause;
  add_dashes(parts, *cause.centre, cause.beside, plumb_width, color);
  add_stroke(parts, parts.pixel(*cause.corner), parts.pixel(cause.beside), lever_width, color);
  add_disc(parts, *cause.corner, corner_radius, color, color);
}

/// No label lies on the outline of a box.
void keep_off_sides(const FrameParts& parts, const SnapshotBox& box, double width) {
  const std::array<Vec2, 4> corner = corners(box);
  for (std::size_t k = 0; k < corner.size(); ++k) {
    parts.labels.keep_off(parts.pixel(corner.at(k)),
                          parts.pixel(corner.at((k + 1) % corner.size())),
                          0.5 * width * parts.unit * parts.fineness);
  }
}

void add_outlines(const FrameParts& parts, const SnapshotCause& cause) {
  const Color color = parts.style.cause;
  for (const int box : cause.part) {
    frame_box(parts, parts.snapshot.boxes[box], part_outline, color, with_alpha(color, 0.0));
    keep_off_sides(parts, parts.snapshot.boxes[box], part_outline);
  }
}

/// Its centre of mass, its weight, and the lever that turns it.
void add_marks(const FrameParts& parts, const SnapshotCause& cause) {
  if (!cause.centre) return;
  const Color color = parts.style.cause;
  if (cause.corner) add_lever(parts, cause);
  const ArrowShape weight = arrow_from(parts, *cause.centre, parts.snapshot.gravity,
                                       mark_arrow_length * parts.unit, color);
  paint_arrows(parts, {{weight}});
  parts.labels.keep_off(weight.tail, weight.tip, static_cast<double>(weight.head_half_width));
  add_disc(parts, *cause.centre, centre_radius, with_alpha(parts.style.halo, 1.0), color);
}

/// The outline of a box in dashes.
void add_moved(const FrameParts& parts, const SnapshotBox& box) {
  const std::array<Vec2, 4> corner = corners(box);
  for (std::size_t k = 0; k < corner.size(); ++k) {
    add_dashes(parts, corner.at(k), corner.at((k + 1) % corner.size()), moved_outline,
               parts.style.mechanism);
  }
}

}  // namespace

void add_causes(const FrameParts& parts) {
  for (const SnapshotCause& cause : parts.snapshot.causes)
    add_outlines(parts, cause);
  for (const SnapshotCause& cause : parts.snapshot.causes)
    add_marks(parts, cause);
  for (const SnapshotCause& cause : parts.snapshot.causes) {
    if (!cause.corner) continue;
    add_label(parts, lever_label(cause), parts.pixel(0.5 * (*cause.corner + cause.beside)),
              parts.style.cause);
  }
}

void add_mechanism(const FrameParts& parts) {
  std::vector<PendingArrow> arrows;
  for (const SnapshotMotion& motion : parts.snapshot.mechanism) {
    const SnapshotBox& box = parts.snapshot.boxes[motion.box];
    const SnapshotBox there = moved_by(box, motion, motion_scale(parts.snapshot));
    add_moved(parts, there);
    const Vec2 way = there.center - box.center;
    const double length = way.norm() * parts.view.pixels_per_metre;
    if (length < shortest_force_arrow * parts.unit * parts.fineness) continue;
    arrows.push_back(
        {arrow_from(parts, box.center, way, length, parts.style.mechanism), ArrowForm::dashed});
  }
  paint_arrows(parts, arrows);
}

}  // namespace wuerfel::internal
