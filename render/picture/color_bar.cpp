// The scale of the bodies' colours: on the right, from much above to little below.
#include <cmath>
#include <string>
#include <utility>

#include "render/picture/hud.h"
#include "render/picture/units.h"

namespace wuerfel::internal {
namespace {

constexpr int steps = 48;
constexpr double highest = 0.22;  ///< of the picture's height
constexpr double lowest = 0.72;
constexpr double thickness = 14.0;  ///< px of a 1280x720 picture

/// Each step up to the top, the next over it: without seams.
void add_steps(const FrameParts& parts, const Area& bar) {
  const double height = bar.bottom - bar.top;
  for (int k = 0; k < steps; ++k) {
    add_bar(parts, {bar.left, bar.top, bar.right, std::round(bar.bottom - k * height / steps)},
            scale_color(parts.style, (k + 0.5) / steps));
  }
}

/// A point at the upper end: there is more than the last colour tells.
void add_point(const FrameParts& parts, const Area& bar) {
  const auto pixel = [](double x, double y) {
    return Pixel{static_cast<float>(x), static_cast<float>(y)};
  };
  const Color color = scale_color(parts.style, 1.0);
  parts.list.add(TriangleShape{
      pixel(bar.left, bar.top), pixel(bar.right, bar.top),
      pixel(0.5 * (bar.left + bar.right), bar.top - thickness * parts.unit), 0.0F, color, color});
}

}  // namespace

void add_color_bar(const FrameParts& parts) {
  const BodyColoring& coloring = parts.options.coloring;
  if (coloring.by != ColorBy::load && coloring.by != ColorBy::speed) return;
  const double top = coloring.top > 0.0 ? coloring.top : largest_value(parts.snapshot, coloring.by);
  const double unit = parts.unit;
  const double size = 0.9 * parts.style.text_size * unit;
  const double right = parts.view.width - hud_margin * unit;
  const double left = right - color_bar_width * unit + 12.0 * unit;
  const Area bar{left, std::round(highest * parts.view.height), left + thickness * unit,
                 std::round(lowest * parts.view.height)};
  const bool load = coloring.by == ColorBy::load;
  const bool above = parts.options.legend.has(LegendEntry::above);
  const double title = bar.top - size - (above ? thickness * unit : 0.0);
  add_plate(parts, {bar.left, title - 1.2 * size, right, bar.bottom + 0.5 * size});
  add_steps(parts, bar);
  if (above) add_point(parts, bar);
  const auto write = [&](std::string text, double x, double y) {
    TextShape shape;
    shape.text = std::move(text);
    shape.baseline = {static_cast<float>(x), static_cast<float>(y)};
    shape.size = static_cast<float>(size);
    shape.color = parts.style.quiet_ink;
    parts.list.texts.push_back(std::move(shape));
  };
  write(load ? "load" : "speed", bar.left, title);
  for (const double share : {0.0, 0.5, 1.0}) {
    if (share > 0.0 && !(top > 0.0)) break;  // all of them bear nothing, or rest
    write((above && share == 1.0 ? "≥ " : "") + with_prefix(share * top, load ? "N" : "m/s", 3),
          bar.right + 6.0 * unit, bar.bottom + share * (bar.top - bar.bottom) + 0.36 * size);
  }
}

}  // namespace wuerfel::internal
