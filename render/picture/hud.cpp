#include "render/picture/hud.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "render/picture/units.h"

namespace wuerfel::internal {
namespace {

constexpr double legend_gap = 26.0;   ///< px, between entries
constexpr double label_gap = 8.0;     ///< between a symbol and its label
constexpr double longest_bar = 0.16;  ///< of the picture's width
constexpr double longest_arrow = 0.12;
constexpr double sample_length = 34.0;  ///< px
constexpr double plate_edge = 7.0;
constexpr double plate_alpha = 0.94;
constexpr double text_halo = 2.0;

/// A rectangle without an outline: a stroke as wide as it is high.
void add_bar(const FrameParts& parts, const Area& area, Color color) {
  const auto middle = static_cast<float>(0.5 * (area.top + area.bottom));
  parts.list.add(SegmentShape{{static_cast<float>(area.left), middle},
                              {static_cast<float>(area.right), middle},
                              static_cast<float>(0.5 * (area.bottom - area.top)),
                              0.0F,
                              color});
}

}  // namespace

void add_plate(const FrameParts& parts, const Area& area) {
  const double edge = plate_edge * parts.unit;
  const Area wide{area.left - edge, area.top - edge, area.right + edge, area.bottom + edge};
  parts.labels.keep_off(wide);
  const Vec2 middle(0.5 * (wide.left + wide.right), 0.5 * (wide.top + wide.bottom));
  const bool ground = parts.has(Layer::cubes) && in_ground(parts, parts.view.to_world(middle));
  const Color below = ground                           ? parts.style.ground
                      : parts.style.background.a < 255 ? parts.style.halo
                                                       : parts.style.background;
  const Color fill = below.a < 255 ? below : with_alpha(below, plate_alpha);
  add_bar(parts, wide, fill);
}

void HudText::add(std::string text, double x, double y, double size, Color color) {
  TextShape shape;
  shape.text = std::move(text);
  shape.baseline = {static_cast<float>(x), static_cast<float>(y)};
  shape.size = static_cast<float>(size);
  shape.color = color;
  texts_.push_back(std::move(shape));
}

void HudText::paint() {
  if (texts_.empty()) return;
  Area all = text_area(texts_.front(), parts_.font);
  for (const TextShape& text : texts_) {
    const Area area = text_area(text, parts_.font);
    all = {std::min(all.left, area.left), std::min(all.top, area.top),
           std::max(all.right, area.right), std::max(all.bottom, area.bottom)};
  }
  add_plate(parts_, all);
  for (TextShape& text : texts_)
    parts_.list.texts.push_back(std::move(text));
}

LegendRow::LegendRow(const FrameParts& parts, Pass pass)
    : parts_(parts),
      pass_(pass),
      size_(parts.style.text_size * parts.unit),
      x_(hud_margin * parts.unit),
      baseline_(parts.view.height - hud_margin * parts.unit) {}

float LegendRow::middle() const { return static_cast<float>(baseline_ - 0.36 * size_); }

void LegendRow::paint_plate() const {
  const double left = hud_margin * parts_.unit;
  const double right = x_ - legend_gap * parts_.unit;
  if (right > left)
    add_plate(parts_, {left, baseline_ - 0.76 * size_, right, baseline_ + 0.2 * size_});
}

template <typename Draw>
void LegendRow::entry(double symbol, std::string_view label, const Draw& draw) {
  const double after = x_ + symbol + label_gap * parts_.unit;
  const double width = parts_.font.width(label, size_);
  if (after + width > parts_.view.width - hud_margin * parts_.unit) return;
  if (pass_ == Pass::painting) {
    draw(static_cast<float>(x_), static_cast<float>(x_ + symbol));
    TextShape text;
    text.text = label;
    text.baseline = {static_cast<float>(after), static_cast<float>(baseline_)};
    text.size = static_cast<float>(size_);
    text.color = parts_.style.quiet_ink;
    parts_.list.texts.push_back(std::move(text));
  }
  x_ = after + width + legend_gap * parts_.unit;
}

void LegendRow::stroke(Pixel from, Pixel to, double width, Color color) {
  parts_.list.add(
      SegmentShape{from, to, static_cast<float>(0.5 * width * parts_.unit), 1.0F, color});
}

void LegendRow::scale_bar() {
  const double ppm = parts_.view.pixels_per_metre;
  const double metres = round_down_125(longest_bar * parts_.view.width / ppm);
  entry(metres * ppm, length_label(metres), [&](float left, float right) {
    const auto tick = static_cast<float>(4.5 * parts_.unit);
    const float y = middle();
    stroke({left, y}, {right, y}, 1.5, parts_.style.quiet_ink);
    for (const float x : {left, right})
      stroke({x, y - tick}, {x, y + tick}, 1.5, parts_.style.quiet_ink);
  });
}

// No longer than arrows of the scene can be.
void LegendRow::arrow(const ArrowScale& scale, Color color, ArrowForm form) {
  const double pixels_per_unit = scale.metres_per_unit * parts_.view.pixels_per_metre;
  const bool force = scale.unit == "N";
  const double cut =
      force ? parts_.options.force_scale.longest * parts_.view.pixels_per_metre : 1e300;
  const double longest = std::min(longest_arrow * parts_.view.width, cut);
  const double amount = round_down_125(longest / pixels_per_unit);
  std::string label = with_prefix(amount, scale.unit);
  if (!scale.meaning.empty()) label += fmt::format(" {}", scale.meaning);
  entry(amount * pixels_per_unit, label, [&](float left, float right) {
    paint_arrows(parts_,
                 {{styled_arrow(parts_, {left, middle()}, {right, middle()}, color), form}});
  });
}

void LegendRow::sample(std::string_view meaning, Color color, ArrowMarks marks) {
  entry(sample_length * parts_.unit, meaning, [&](float left, float right) {
    const ArrowForm form = marks.hollow ? ArrowForm::hollow : ArrowForm::filled;
    paint_arrows(parts_, {{styled_arrow(parts_, {left, middle()}, {right, middle()}, color), form,
                           marks.cut}});
  });
}

void LegendRow::normal(std::string_view meaning) {
  entry(0.6 * sample_length * parts_.unit, meaning, [&](float left, float right) {
    paint_normal(parts_, {left, middle()}, {right, middle()});
  });
}

void LegendRow::dot(std::string_view meaning, Color color) {
  entry(6.0 * parts_.unit, meaning, [&](float left, float right) {
    add_dot(parts_, {0.5F * (left + right), middle()}, color, force_dot);
  });
}

void LegendRow::ring(std::string_view meaning, Color color) {
  entry(14.0 * parts_.unit, meaning, [&](float left, float right) {
    DiscShape ring;
    ring.center = {0.5F * (left + right), middle()};
    ring.radius = 0.5F * (right - left);
    ring.outline_width = static_cast<float>(2.0 * parts_.unit);
    ring.fill = with_alpha(color, 0.2);
    ring.outline = with_alpha(color, 0.8);
    parts_.list.add(ring);
  });
}

void LegendRow::swatch(std::string_view meaning, Color color) {
  entry(26.0 * parts_.unit, meaning, [&](float left, float right) {
    stroke({left, middle()}, {right, middle()}, 5.0, color);
  });
}

void LegendRow::dashes(std::string_view meaning, Color color) {
  entry(34.0 * parts_.unit, meaning, [&](float left, float right) {
    for (const float share : {0.0F, 0.38F, 0.76F}) {
      const float from = left + share * (right - left);
      stroke({from, middle()}, {from + 0.24F * (right - left), middle()}, 2.6, color);
    }
  });
}

// On the right, from much above to little below.
void add_color_bar(const FrameParts& parts) {
  const BodyColoring& coloring = parts.options.coloring;
  if (coloring.by != ColorBy::load && coloring.by != ColorBy::speed) return;
  constexpr int steps = 48;
  const double top = coloring.top > 0.0 ? coloring.top : largest_value(parts.snapshot, coloring.by);
  const double unit = parts.unit;
  const double size = 0.9 * parts.style.text_size * unit;
  const double right = parts.view.width - hud_margin * unit;
  const double bar_left = right - color_bar_width * unit + 12.0 * unit;
  const double bar_width = 14.0 * unit;
  const double high = 0.22 * parts.view.height;
  const double low = 0.72 * parts.view.height;
  const bool load = coloring.by == ColorBy::load;
  add_plate(parts, {bar_left, high - 2.2 * size, right, low + 0.5 * size});
  for (int k = 0; k < steps; ++k) {
    const double step = (low - high) / steps;
    add_bar(parts,
            {bar_left, low - (k + 1) * step - 0.3, bar_left + bar_width, low - k * step + 0.3},
            scale_color(parts.style, (k + 0.5) / steps));
  }
  const auto write = [&](std::string text, double x, double y) {
    TextShape shape;
    shape.text = std::move(text);
    shape.baseline = {static_cast<float>(x), static_cast<float>(y)};
    shape.size = static_cast<float>(size);
    shape.color = parts.style.quiet_ink;
    parts.list.texts.push_back(std::move(shape));
  };
  write(load ? "load" : "speed", bar_left, high - 1.0 * size);
  for (const double share : {0.0, 0.5, 1.0}) {
    write(with_prefix(share * top, load ? "N" : "m/s", 3), bar_left + bar_width + 6.0 * unit,
          low + share * (high - low) + 0.36 * size);
  }
}

}  // namespace wuerfel::internal
