#include "render/picture/hud.h"

#include <algorithm>
#include <array>
#include <cmath>
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

/// A rectangle without an outline: a stroke as wide as it is high.
void add_bar(const FrameParts& parts, const Area& area, Color color) {
  const auto middle = static_cast<float>(0.5 * (area.top + area.bottom));
  parts.list.add(SegmentShape{{static_cast<float>(area.left), middle},
                              {static_cast<float>(area.right), middle},
                              static_cast<float>(0.5 * (area.bottom - area.top)),
                              0.0F,
                              color});
}

/// The part of an area that lies in a half-plane: a convex polygon (Sutherland and Hodgman 1974).
std::vector<Vec2> solid_part(const FrameParts& parts,
                             const SnapshotPlane& plane,
                             const Area& area) {
  const std::array<Vec2, 4> corners{Vec2(area.left, area.top), Vec2(area.right, area.top),
                                    Vec2(area.right, area.bottom), Vec2(area.left, area.bottom)};
  const auto depth = [&](const Vec2& pixel) {
    return (plane.point - parts.view.to_world(pixel)).dot(plane.normal);
  };
  std::vector<Vec2> part;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2& p = corners.at(i);
    const Vec2& q = corners.at((i + 1) % corners.size());
    const double at_p = depth(p);
    const double at_q = depth(q);
    if (at_p >= 0.0) part.push_back(p);
    if ((at_p >= 0.0) != (at_q >= 0.0)) part.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return part;
}

/// A polygon of one colour; those along the picture's edges without a seam.
void add_polygon(const FrameParts& parts, const std::vector<Vec2>& corners, Color color) {
  if (corners.size() < 3) return;
  Area around{1e300, 1e300, -1e300, -1e300};
  for (const Vec2& p : corners)
    around = {std::min(around.left, p.x()), std::min(around.top, p.y()),
              std::max(around.right, p.x()), std::max(around.bottom, p.y())};
  const auto on_edge = [&around](const Vec2& p) {
    constexpr double hair = 1e-6;  // px
    return std::min(p.x() - around.left, around.right - p.x()) < hair
           && std::min(p.y() - around.top, around.bottom - p.y()) < hair;
  };
  if (std::ranges::all_of(corners, on_edge)) return add_bar(parts, around, color);
  const auto pixel = [](const Vec2& p) {
    return Pixel{static_cast<float>(p.x()), static_cast<float>(p.y())};
  };
  for (std::size_t i = 2; i < corners.size(); ++i)
    parts.list.add(TriangleShape{pixel(corners[0]), pixel(corners[i - 1]), pixel(corners[i]), 0.0F,
                                 color, color});
}

}  // namespace

void add_plate(const FrameParts& parts, const Area& area) {
  const double edge = plate_edge * parts.unit;
  // Whole pixels: what lies on one another has no seams.
  const Area wide{std::floor(area.left - edge), std::floor(area.top - edge),
                  std::ceil(area.right + edge), std::ceil(area.bottom + edge)};
  parts.labels.keep_off(wide);
  add_bar(parts, wide, parts.style.background.a < 255 ? parts.style.halo : parts.style.background);
  if (!parts.has(Layer::cubes)) return;
  for (const SnapshotPlane& plane : parts.snapshot.planes)
    add_polygon(parts, solid_part(parts, plane, wide), parts.style.ground);
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
  add_plate(parts_, common_area(texts_, parts_.font));
  for (TextShape& text : texts_)
    parts_.list.texts.push_back(std::move(text));
}

LegendRow::LegendRow(const FrameParts& parts, Pass pass, int rows)
    : parts_(parts),
      pass_(pass),
      size_(parts.style.text_size * parts.unit),
      x_(hud_margin * parts.unit),
      baseline_(parts.view.height - hud_margin * parts.unit - (rows - 1) * line_height * size_),
      right_(x_) {}

float LegendRow::middle() const { return static_cast<float>(baseline_ - 0.36 * size_); }

void LegendRow::paint_plate() const {
  const double left = hud_margin * parts_.unit;
  const double bottom = parts_.view.height - hud_margin * parts_.unit;
  if (right_ > left)
    add_plate(parts_,
              {left, bottom - (0.76 + row_ * line_height) * size_, right_, bottom + 0.2 * size_});
}

template <typename Draw>
void LegendRow::entry(double symbol, std::string_view label, const Draw& draw) {
  // The foot of a strip has room for one at first.
  const double height = parts_.view.height - hud_margin * parts_.unit;
  const bool second = row_ == 0 && height > (0.76 + line_height) * size_;
  const double width = parts_.font.width(label, size_);
  const double wanted = symbol + label_gap * parts_.unit + width;
  const double end = parts_.view.width - hud_margin * parts_.unit;
  if (x_ + wanted > end) {
    const double start = hud_margin * parts_.unit;
    if (!second || start + wanted > end) {
      if (pass_ == Pass::painting) ++parts_.list.legend_left_out;
      return;
    }
    ++row_;
    x_ = start;
    baseline_ += line_height * size_;
  }
  const double after = x_ + wanted - width;
  if (pass_ == Pass::painting) {
    draw(static_cast<float>(x_), static_cast<float>(x_ + symbol));
    TextShape text;
    text.text = label;
    text.baseline = {static_cast<float>(after), static_cast<float>(baseline_)};
    text.size = static_cast<float>(size_);
    text.color = parts_.style.quiet_ink;
    parts_.list.texts.push_back(std::move(text));
  }
  right_ = std::max(right_, after + width);
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

void LegendRow::comb(std::string_view meaning, Color color) {
  entry(28.0 * parts_.unit, meaning, [&](float left, float right) {
    const auto reach = static_cast<float>(5.0 * parts_.unit);
    for (const float share : {0.0F, 0.25F, 0.5F, 0.75F, 1.0F}) {
      const float x = left + share * (right - left);
      stroke({x, middle() - reach}, {x, middle() + reach}, 1.0, with_alpha(color, 0.75));
    }
    stroke({left, middle() + reach}, {right, middle() + reach}, 1.6, with_alpha(color, 0.75));
  });
}

void LegendRow::whisker(std::string_view meaning) {
  entry(sample_length * parts_.unit, meaning, [&](float left, float right) {
    paint_whisker(parts_, {left, middle()}, {right, middle()});
  });
}

void LegendRow::moved_box(std::string_view meaning, Color color) {
  const double side = 15.0 * parts_.unit;
  entry(side, meaning, [&](float left, float right) {
    const float half = 0.5F * (right - left);
    const std::array<Pixel, 4> corner{{{left, middle() - half},
                                       {right, middle() - half},
                                       {right, middle() + half},
                                       {left, middle() + half}}};
    for (std::size_t k = 0; k < corner.size(); ++k) {
      const Pixel& p = corner.at(k);
      const Pixel& q = corner.at((k + 1) % corner.size());
      for (const float share : {0.0F, 0.375F, 0.75F})
        stroke({p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)},
               {p.x + (share + 0.25F) * (q.x - p.x), p.y + (share + 0.25F) * (q.y - p.y)}, 1.8,
               color);
    }
  });
}

void LegendRow::failing_box(std::string_view meaning, Color color) {
  entry(16.0 * parts_.unit, meaning, [&](float left, float right) {
    BoxShape box;
    box.center = {0.5F * (left + right), middle()};
    box.half_size = {0.5F * (right - left), 0.5F * (right - left)};
    box.outline_width = static_cast<float>(3.6 * parts_.unit);
    box.outline = color;
    box.fill = with_alpha(color, 0.0);
    parts_.list.add(box);
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
  const double high = std::round(0.22 * parts.view.height);
  const double low = std::round(0.72 * parts.view.height);
  const bool load = coloring.by == ColorBy::load;
  add_plate(parts, {bar_left, high - 2.2 * size, right, low + 0.5 * size});
  // Each up to the top, the next over it: without seams.
  for (int k = 0; k < steps; ++k)
    add_bar(parts,
            {bar_left, high, bar_left + bar_width, std::round(low - k * (low - high) / steps)},
            scale_color(parts.style, (k + 0.5) / steps));
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
