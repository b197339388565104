// What would help, and why a scene stands or falls in words above and below.
#include <algorithm>
#include <string>
#include <vector>

#include "render/picture/hud.h"
#include "render/picture/marks.h"

namespace wuerfel::internal {
namespace {

// Pixels of a 1280x720 picture.
constexpr double ghost_outline = 2.2;
constexpr double least_way = 24.0;  ///< shorter ways are shown by an arrow of this length
constexpr double ghost_fill = 0.16;

Color helping(const FrameParts& parts) { return parts.style.positive_side; }

/// Where the label of a fix belongs.
Pixel add_fix(const FrameParts& parts,
              const SnapshotReason::Fix& fix,
              std::vector<PendingArrow>& arrows) {
  const Color color = helping(parts);
  if (fix.moved.empty()) {  // it pushes: inside the picture, where the bodies are
    const double length = mark_arrow_length * parts.unit;
    const Vec2 tail = fix.point - parts.metres(length) * fix.force.normalized();
    arrows.push_back({arrow_from(parts, tail, fix.force, length, color)});
    return arrows.back().shape.tail;
  }
  const double length =
      std::max(fix.way.norm() * parts.view.pixels_per_metre, least_way * parts.unit);
  arrows.push_back({arrow_from(parts, fix.point, fix.way, length, color)});
  return arrows.back().shape.tip;
}

/// Lines from a baseline on, each as small as it has to be.
void add_lines(const FrameParts& parts,
               const std::vector<std::string>& lines,
               double y,
               bool title) {
  const double x = hud_margin * parts.unit;
  const double room = parts.view.width - 2.0 * x;
  HudText text(parts);
  bool first = title;
  for (const std::string& line : lines) {
    const double full = (first ? parts.style.title_size : parts.style.text_size) * parts.unit;
    const double size = full * std::min(1.0, room / parts.font.width(line, full));
    y += 0.78 * full;
    text.add(line, x, y, size, parts.style.ink);
    y += 0.55 * full;
    first = false;
  }
  text.paint();
}

}  // namespace

void add_moved_boxes(const FrameParts& parts) {
  const Color color = helping(parts);
  for (const SnapshotReason::Fix& fix : parts.snapshot.reason->fixes) {
    for (const int number : fix.moved) {
      frame_box(parts, moved_by(parts.snapshot.boxes[number], fix.way), ghost_outline, color,
                with_alpha(color, ghost_fill));
    }
  }
}

void add_fixes(const FrameParts& parts) {
  const std::vector<SnapshotReason::Fix>& fixes = parts.snapshot.reason->fixes;
  std::vector<PendingArrow> arrows;
  std::vector<Pixel> places;
  places.reserve(fixes.size());
  for (const SnapshotReason::Fix& fix : fixes)
    places.push_back(add_fix(parts, fix, arrows));
  paint_arrows(parts, arrows);
  for (const PendingArrow& a : arrows)
    parts.labels.keep_off(a.shape.tail, a.shape.tip, static_cast<double>(a.shape.head_half_width));
  for (std::size_t i = 0; i < places.size(); ++i)
    add_label(parts, fixes[i].label, places[i], helping(parts));
}

void add_reason_text(const FrameParts& parts) {
  const SnapshotReason& reason = *parts.snapshot.reason;
  const double margin = hud_margin * parts.unit;
  add_lines(parts, reason.headlines, margin, true);
  const double line = line_height * parts.style.text_size * parts.unit;
  const double height = line * static_cast<double>(reason.advice.size());
  add_lines(parts, reason.advice, parts.view.height - margin - height, false);
}

}  // namespace wuerfel::internal
