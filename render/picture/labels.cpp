#include "render/picture/labels.h"

#include <algorithm>
#include <utility>

namespace wuerfel::internal {
namespace {

bool overlap(const Area& a, const Area& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/// Whether the stroke from p to q has a point in the area (Liang and Barsky 1984).
bool crosses(const Area& area, Pixel p, Pixel q) {
  double from = 0.0;
  double to = 1.0;
  const auto keep = [&](double start, double rate) {  // where start + rate s >= 0
    if (rate > 0.0) from = std::max(from, -start / rate);
    if (rate < 0.0) to = std::min(to, -start / rate);
    if (rate == 0.0 && start < 0.0) to = -1.0;
  };
  const double dx = static_cast<double>(q.x) - static_cast<double>(p.x);
  const double dy = static_cast<double>(q.y) - static_cast<double>(p.y);
  keep(static_cast<double>(p.x) - area.left, dx);
  keep(area.right - static_cast<double>(p.x), -dx);
  keep(static_cast<double>(p.y) - area.top, dy);
  keep(area.bottom - static_cast<double>(p.y), -dy);
  return from <= to;
}

}  // namespace

Area text_area(const TextShape& text, Font& font) {
  const auto size = static_cast<double>(text.size);
  const auto x = static_cast<double>(text.baseline.x);
  const auto y = static_cast<double>(text.baseline.y);
  return {x, y - 0.76 * size, x + font.width(text.text, size), y + 0.2 * size};
}

Area common_area(std::span<const TextShape> texts, Font& font) {
  Area all{1e300, 1e300, -1e300, -1e300};
  for (const TextShape& text : texts) {
    const Area area = text_area(text, font);
    all = {std::min(all.left, area.left), std::min(all.top, area.top),
           std::max(all.right, area.right), std::max(all.bottom, area.bottom)};
  }
  return all;
}

void Labels::keep_off(Pixel from, Pixel to, double half_width) {
  strokes_.push_back({from, to, half_width});
}

bool Labels::is_free(const Area& area) const {
  if (area.left < picture_.left || area.top < picture_.top || area.right > picture_.right
      || area.bottom > picture_.bottom)
    return false;
  if (std::ranges::any_of(areas_, [&](const Area& other) { return overlap(area, other); }))
    return false;
  return std::ranges::none_of(strokes_, [&](const Stroke& stroke) {
    const double w = stroke.half_width;
    return crosses({area.left - w, area.top - w, area.right + w, area.bottom + w}, stroke.from,
                   stroke.to);
  });
}

bool Labels::place(TextShape text, std::span<const Pixel> baselines, Font& font, DrawList& list) {
  text.baseline = {};
  return place(std::vector<TextShape>{std::move(text)}, baselines, font, list);
}

bool Labels::place(std::vector<TextShape> texts,
                   std::span<const Pixel> baselines,
                   Font& font,
                   DrawList& list) {
  const Area own = common_area(texts, font);
  for (const Pixel baseline : baselines) {
    const auto x = static_cast<double>(baseline.x);
    const auto y = static_cast<double>(baseline.y);
    const Area area{own.left + x, own.top + y, own.right + x, own.bottom + y};
    if (!is_free(area)) continue;
    keep_off(area);
    for (TextShape& text : texts) {
      text.baseline = {text.baseline.x + baseline.x, text.baseline.y + baseline.y};
      list.texts.push_back(std::move(text));
    }
    return true;
  }
  ++list.labels_left_out;
  return false;
}

}  // namespace wuerfel::internal
