// The HUD: title, time and energy at the top, scale bar and arrow legend at the bottom, all with
// round numbers.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "render/picture/frame_parts.h"

namespace wuerfel::internal {
namespace {

constexpr double margin = 20.0;       ///< px of a 1280x720 picture
constexpr double legend_gap = 30.0;   ///< between entries
constexpr double label_gap = 9.0;     ///< between a symbol and its label
constexpr double longest_bar = 0.16;  ///< of the picture's width
constexpr double longest_arrow = 0.075;

/// "2 kN" for 2000 and "N": a number with the prefix that makes it easy to read.
std::string with_prefix(double value, std::string_view unit) {
  struct Prefix {
    double factor;
    std::string_view name;
  };
  constexpr std::array<Prefix, 7> prefixes{
      {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1.0, ""}, {1e-3, "m"}, {1e-6, "µ"}, {1e-9, "n"}}};
  for (const Prefix& prefix : prefixes) {
    if (value >= prefix.factor * (1.0 - 1e-9)) {
      return fmt::format("{:.6g} {}{}", value / prefix.factor, prefix.name, unit);
    }
  }
  return fmt::format("{:.3g} {}", value, unit);
}

/// Centimetres are what people use between a millimetre and a metre.
std::string length_label(double metres) {
  if (metres < 1.0 && metres >= 0.01 * (1.0 - 1e-9))
    return fmt::format("{:.6g} cm", 100.0 * metres);
  return with_prefix(metres, "m");
}

/// Energy to a thousandth of its size, so that the digits stand still while it changes.
std::string energy_label(double joule) {
  const double size = std::abs(joule);
  if (size >= 1e6) return fmt::format("{:.2f} MJ", joule * 1e-6);
  if (size >= 1e4) return fmt::format("{:.2f} kJ", joule * 1e-3);
  const int decimals = size >= 1000.0 ? 0 : size >= 100.0 ? 1 : 2;
  return fmt::format("{:.{}f} J", joule, decimals);
}

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

void add_text(
    const FrameParts& parts, std::string text, double x, double y, double size, Color color) {
  TextShape shape;
  shape.text = std::move(text);
  shape.baseline = {static_cast<float>(x), static_cast<float>(y)};
  shape.size = static_cast<float>(size);
  shape.color = color;
  // The halo has the colour of what lies below, so that it only shows where bodies are.
  shape.halo = parts.style.halo;
  if (parts.has(Layer::cubes) && in_ground(parts, parts.view.to_world(Vec2(x, y))))
    shape.halo = parts.style.ground;
  shape.halo_width = static_cast<float>(2.5 * parts.unit);
  parts.list.texts.push_back(std::move(shape));
}

/// A row of symbols with labels, from left to right.
class LegendRow {
 public:
  explicit LegendRow(const FrameParts& parts)
      : parts_(parts),
        size_(parts.style.text_size * parts.unit),
        x_(margin * parts.unit),
        baseline_(parts.view.height - margin * parts.unit) {}

  void scale_bar() {
    const double ppm = parts_.view.pixels_per_metre;
    const double metres = round_down_125(longest_bar * parts_.view.width / ppm);
    const std::string label = length_label(metres);
    if (!fits(metres * ppm, label)) return;
    const auto tick = static_cast<float>(4.5 * parts_.unit);
    const auto left = static_cast<float>(x_);
    const auto right = static_cast<float>(x_ + metres * ppm);
    const float y = middle();
    stroke({left, y}, {right, y});
    stroke({left, y - tick}, {left, y + tick});
    stroke({right, y - tick}, {right, y + tick});
    finish_entry(metres * ppm, label);
  }

  /// An arrow of a round number of `unit` at `metres_per_unit`.
  void arrow(double metres_per_unit, std::string_view unit, std::string_view meaning, Color color) {
    const double pixels_per_unit = metres_per_unit * parts_.view.pixels_per_metre;
    const double amount = round_down_125(longest_arrow * parts_.view.width / pixels_per_unit);
    std::string label = with_prefix(amount, unit);
    if (!meaning.empty()) label += fmt::format(" {}", meaning);
    const double length = amount * pixels_per_unit;
    if (!fits(length, label)) return;
    const auto left = static_cast<float>(x_);
    const auto right = static_cast<float>(x_ + length);
    paint_arrows(parts_, {{styled_arrow(parts_, {left, middle()}, {right, middle()}, color)}});
    finish_entry(length, label);
  }

  /// A thick stroke: rods in tension or compression.
  void swatch(std::string_view meaning, Color color) {
    const double length = 26.0 * parts_.unit;
    if (!fits(length, std::string(meaning))) return;
    const auto left = static_cast<float>(x_);
    const auto right = static_cast<float>(x_ + length);
    parts_.list.add(SegmentShape{
        {left, middle()}, {right, middle()}, static_cast<float>(2.5 * parts_.unit), 1.0F, color});
    finish_entry(length, std::string(meaning));
  }

 private:
  float middle() const { return static_cast<float>(baseline_ - 0.36 * size_); }
  bool fits(double symbol, const std::string& label) const {
    return x_ + symbol + label_gap * parts_.unit + parts_.font.width(label, size_)
           <= parts_.view.width - margin * parts_.unit;
  }
  void stroke(Pixel from, Pixel to) {
    parts_.list.add(SegmentShape{from, to, static_cast<float>(0.75 * parts_.unit), 1.0F,
                                 parts_.style.quiet_ink});
  }
  void finish_entry(double symbol, const std::string& label) {
    x_ += symbol + label_gap * parts_.unit;
    add_text(parts_, label, x_, baseline_, size_, parts_.style.quiet_ink);
    x_ += parts_.font.width(label, size_) + legend_gap * parts_.unit;
  }

  const FrameParts& parts_;
  double size_;
  double x_;
  double baseline_;
};

void add_head(const FrameParts& parts) {
  const double x = margin * parts.unit;
  const double title = parts.style.title_size * parts.unit;
  const double text = parts.style.text_size * parts.unit;
  double y = margin * parts.unit;
  if (!parts.snapshot.title.empty()) {
    y += 0.78 * title;
    add_text(parts, fitted(parts, parts.snapshot.title, title, parts.view.width - 2.0 * x), x, y,
             title, parts.style.ink);
    y += 0.75 * text;
  }
  y += 0.78 * text;
  const std::string time = fmt::format("t = {:.3f} s", parts.snapshot.time);
  add_text(parts, time, x, y, text, parts.style.quiet_ink);
  // The place of the energy does not depend on the digits of the time.
  const double column = parts.font.width("t = 00.000 s", text) + legend_gap * parts.unit;
  add_text(parts, "E = " + energy_label(parts.snapshot.energy), x + column, y, text,
           parts.style.quiet_ink);
}

std::string_view meaning(ForceKind kind) {
  switch (kind) {
    case ForceKind::friction:
      return "friction";
    case ForceKind::rod_tension:
      return "tension";
    case ForceKind::rod_compression:
      return "compression";
    case ForceKind::contact:
      break;
  }
  return "contact";
}

}  // namespace

void add_hud(const FrameParts& parts) {
  add_head(parts);
  LegendRow row(parts);
  row.scale_bar();
  const FrameOptions& options = parts.options;
  if (parts.has(Layer::forces) && options.force_scale.metres_per_newton > 0.0) {
    for (const ForceKind kind : options.legend) {
      const bool alone = options.legend.size() == 1;
      row.arrow(options.force_scale.metres_per_newton, "N", alone ? "" : meaning(kind),
                force_color(parts.style, kind));
    }
  }
  if (parts.has(Layer::velocities) && options.metres_per_speed > 0.0) {
    row.arrow(options.metres_per_speed, "m/s", "", parts.style.velocity);
  }
  if (parts.has(Layer::rod_forces)) {
    row.swatch("tension", parts.style.tension);
    row.swatch("compression", parts.style.compression);
  }
}

}  // namespace wuerfel::internal
