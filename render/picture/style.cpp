#include "render/picture/style.h"

#include <cstddef>

namespace wuerfel {
namespace {

constexpr std::array<std::string_view, 4> theme_names{"light", "dark", "print", "transparent"};

/// M. Okabe, K. Ito: Color Universal Design (2008), without black; ordered so that neighbours
/// differ in hue and brightness: blue, orange, green, sky blue, vermilion, yellow, reddish purple.
constexpr std::array<Color, 7> okabe_ito{rgb(0x0072B2), rgb(0xE69F00), rgb(0x009E73), rgb(0x56B4E9),
                                         rgb(0xD55E00), rgb(0xF0E442), rgb(0xCC79A7)};

/// Okabe-Ito moved by `share` towards `ground`.
std::array<Color, 7> softened(Color ground, double share) {
  std::array<Color, 7> palette = okabe_ito;
  for (Color& color : palette)
    color = mix(color, ground, share);
  return palette;
}

/// Colours of arrows and sides differ by at least 15 (CIE76) for readers of every kind of colour
/// vision, as Machado et al. 2009 simulate it: found by a search near the colours that one would
/// choose, checked by a test.
Style light() {
  Style style;
  style.theme = Theme::light;
  style.background = rgb(0xFFFFFF);
  style.ink = rgb(0x1B2430);
  style.quiet_ink = rgb(0x566070);
  style.ground = rgb(0xE9ECF0);
  style.fixed = rgb(0xD3D8E0);
  style.ground_line = rgb(0x3A4452);
  style.hatch = rgb(0xB4BCC8);
  style.grid = rgb(0xECEEF2);
  style.grid_axis = rgb(0xD3D8E0);
  style.palette = softened(rgb(0xFFFFFF), 0.22);
  style.outline = rgb(0x10161E);
  style.outline_shade = 0.62;
  style.rod = rgb(0x2B3440);
  style.joint = rgb(0xFFFFFF);
  style.mass = rgb(0x1B2430);
  style.contact = rgb(0xA80F2B);
  style.friction = rgb(0x9E33F5);
  style.tension = rgb(0x3325AB);
  style.compression = rgb(0xD57500);
  style.velocity = rgb(0x1F4B4E);
  style.acceleration = rgb(0xA50692);
  style.own_weight = rgb(0x00005E);
  style.thrust = rgb(0x3778D3);
  style.whisker = rgb(0x1B1B1B);
  style.mechanism = rgb(0x483600);
  style.cause = rgb(0xCF1B00);
  style.normal = rgb(0x8792C7);
  style.positive_side = rgb(0x35C03D);
  style.negative_side = rgb(0xED557B);
  style.chain = rgb(0x10161E);
  style.halo = rgb(0xFFFFFF);
  return style;
}

Style dark() {
  Style style = light();
  style.theme = Theme::dark;
  style.background = rgb(0x12161C);
  style.ink = rgb(0xEEF1F5);
  style.quiet_ink = rgb(0xA2ADBB);
  style.ground = rgb(0x1F2630);
  style.fixed = rgb(0x343E4C);
  style.ground_line = rgb(0x8D9AAB);
  style.hatch = rgb(0x465262);
  style.grid = rgb(0x1D232C);
  style.grid_axis = rgb(0x303A47);
  style.palette = softened(rgb(0x12161C), 0.16);
  style.outline = rgb(0xFFFFFF);
  style.outline_shade = 0.45;
  style.rod = rgb(0xE4E9EF);
  style.joint = rgb(0x12161C);
  style.mass = rgb(0xF4F6F8);
  style.contact = rgb(0xFF5D6C);
  style.friction = rgb(0xBFCCCF);
  style.tension = rgb(0x9F9FFF);
  style.compression = rgb(0xC17126);
  style.velocity = rgb(0x89CF9E);
  style.acceleration = rgb(0xEBB3FF);
  style.own_weight = rgb(0xE6FFD3);
  style.thrust = rgb(0x5B46FE);
  style.whisker = rgb(0xAB9099);
  style.mechanism = rgb(0xEAF35A);
  style.cause = rgb(0xFCA236);
  style.normal = rgb(0x4778E2);
  style.positive_side = rgb(0x74F576);
  style.negative_side = rgb(0xEF5FBF);
  style.halo = rgb(0x12161C);
  return style;
}

/// Told apart by brightness alone, for a black-and-white printer.
Style print() {
  Style style = light();
  style.theme = Theme::print;
  style.ink = rgb(0x000000);
  style.quiet_ink = rgb(0x333333);
  style.ground = rgb(0xFFFFFF);
  style.fixed = rgb(0xFFFFFF);
  style.ground_line = rgb(0x000000);
  style.hatch = rgb(0x000000);
  style.grid = rgb(0xE6E6E6);
  style.grid_axis = rgb(0xC4C4C4);
  style.palette = {rgb(0xE2E2E2), rgb(0xC2C2C2), rgb(0xF4F4F4), rgb(0xD2D2D2),
                   rgb(0xB2B2B2), rgb(0xEBEBEB), rgb(0xCACACA)};
  style.outline = rgb(0x000000);
  style.outline_shade = 1.0;
  style.rod = rgb(0x000000);
  style.mass = rgb(0x000000);
  style.contact = rgb(0x000000);
  style.friction = rgb(0x6B6B6B);
  style.tension = rgb(0x000000);
  style.compression = rgb(0x808080);
  style.velocity = rgb(0x4A4A4A);
  style.acceleration = rgb(0x000000);
  style.own_weight = rgb(0x4A4A4A);
  style.thrust = rgb(0x000000);
  style.whisker = rgb(0x000000);
  style.mechanism = rgb(0x6B6B6B);
  style.cause = rgb(0x000000);
  style.normal = rgb(0x6B6B6B);
  style.positive_side = rgb(0x9A9A9A);
  style.negative_side = rgb(0x303030);
  style.outline_width = 2.0;
  style.ground_line_width = 2.6;
  style.arrow_width = 3.6;
  return style;
}

/// For slides of any colour: no background; a translucent halo keeps arrows and text readable on
/// dark ones.
Style transparent() {
  Style style = light();
  style.theme = Theme::transparent;
  style.background = {0, 0, 0, 0};
  style.quiet_ink = style.ink;
  style.halo = with_alpha(rgb(0xFFFFFF), 0.8);
  style.grid = with_alpha(rgb(0x6B7787), 0.25);
  style.grid_axis = with_alpha(rgb(0x6B7787), 0.5);
  return style;
}

/// A grey as bright as the colour, but never so dark that a black arrow is lost on it.
Color print_grey(Color color) {
  constexpr double darkest = 0.6;
  const auto level =
      static_cast<std::uint8_t>(255.0 * (darkest + (1.0 - darkest) * brightness(color)));
  return {level, level, level, 255};
}

}  // namespace

std::string_view to_string(Theme theme) {
  const auto i = static_cast<std::size_t>(theme);
  return i < theme_names.size() ? theme_names.at(i) : "?";
}

Style make_style(Theme theme) {
  switch (theme) {
    case Theme::dark:
      return dark();
    case Theme::print:
      return print();
    case Theme::transparent:
      return transparent();
    case Theme::light:
      break;
  }
  return light();
}

Color body_color(const Style& style, const SnapshotBox& box) {
  if (box.color) {
    const Color color{(*box.color)[0], (*box.color)[1], (*box.color)[2], 255};
    return style.theme == Theme::print ? print_grey(color) : color;
  }
  if (box.fixed) return style.fixed;
  const auto count = static_cast<int>(style.palette.size());
  const int index = ((box.color_index % count) + count) % count;
  return style.palette.at(static_cast<std::size_t>(index));
}

Color force_color(const Style& style, ForceKind kind) {
  switch (kind) {
    case ForceKind::friction:
      return style.friction;
    case ForceKind::rod_tension:
      return style.tension;
    case ForceKind::rod_compression:
      return style.compression;
    case ForceKind::contact:
      break;
  }
  return style.contact;
}

}  // namespace wuerfel
