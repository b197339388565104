// The symbols of a legend with their labels.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "render/picture/hud.h"
#include "render/picture/units.h"

namespace wuerfel::internal {
namespace {

constexpr double legend_gap = 26.0;   ///< px of a 1280x720 picture, between entries
constexpr double label_gap = 8.0;     ///< between a symbol and its label
constexpr double longest_bar = 0.16;  ///< of the picture's width
constexpr double longest_arrow = 0.12;
constexpr double sample_length = 34.0;  ///< px

}  // namespace

LegendRow::LegendRow(const FrameParts& parts, Pass pass, double share, int rows)
    : parts_(parts),
      pass_(pass),
      size_(parts.style.text_size * parts.unit),
      x_(hud_margin * parts.unit),
      baseline_(parts.view.height - hud_margin * parts.unit - (rows - 1) * line_height * size_),
      right_(x_),
      end_(x_ + share * (parts.view.width - 2.0 * x_)) {}

float LegendRow::middle() const { return static_cast<float>(baseline_ - 0.36 * size_); }

void LegendRow::paint_plate() const {
  const double left = hud_margin * parts_.unit;
  const double bottom = parts_.view.height - hud_margin * parts_.unit;
  if (right_ > left) {
    add_plate(parts_,
              {left, bottom - (0.76 + row_ * line_height) * size_, right_, bottom + 0.2 * size_});
  }
}

// Two rows are always as many as a picture has room for, but the foot of a strip may have less.
bool LegendRow::has_room_below() const {
  constexpr double most = 0.2;  // of the picture's width, that further ones may be high
  const double height = (0.76 + (row_ + 1) * line_height) * size_;
  return height < parts_.view.height - hud_margin * parts_.unit
         && (row_ == 0 || height <= most * parts_.view.width);
}

template <typename Draw>
void LegendRow::entry(double symbol, std::string_view label, const Draw& draw) {
  const double width = parts_.font.width(label, size_);
  const double wanted = symbol + label_gap * parts_.unit + width;
  if (x_ + wanted > end_) {
    const double start = hud_margin * parts_.unit;
    if (!has_room_below() || start + wanted > end_) {
      ++left_out_;
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

void LegendRow::triangle(std::string_view meaning, bool negative) {
  entry(24.0 * parts_.unit, meaning, [&](float left, float right) {
    const auto reach = static_cast<float>(7.0 * parts_.unit);
    const float foot = middle() + (negative ? -reach : reach);
    const float tip = middle() + (negative ? reach : -reach);
    paint_side(parts_, {{{left, foot}, {right, foot}, {0.5F * (left + right), tip}}}, negative);
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

void LegendRow::whisker(std::string_view meaning, bool goes_on) {
  entry(sample_length * parts_.unit, meaning, [&](float left, float right) {
    paint_whisker(parts_, {left, middle()}, {right, middle()}, goes_on);
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
      for (const float share : {0.0F, 0.375F, 0.75F}) {
        stroke({p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)},
               {p.x + (share + 0.25F) * (q.x - p.x), p.y + (share + 0.25F) * (q.y - p.y)}, 1.8,
               color);
      }
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

}  // namespace wuerfel::internal
