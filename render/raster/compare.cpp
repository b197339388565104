#include "render/raster/compare.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

#include <fmt/format.h>

#include "render/raster/text.h"

namespace wuerfel {
namespace {

constexpr Color beyond{220, 20, 40, 255};
constexpr Color within{250, 200, 0, 255};
constexpr Color paper{255, 255, 255, 255};

int difference(Color a, Color b) {
  if (a.a == 0 && b.a == 0) return 0;
  return std::max(
      {std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b), std::abs(a.a - b.a)});
}

/// What lies outside a picture differs by all there is.
int difference_at(const Image& expected, const Image& actual, int x, int y) {
  const auto inside = [x, y](const Image& image) {
    return x < image.width() && y < image.height();
  };
  if (!inside(expected) || !inside(actual)) return 255;
  return difference(expected.at(x, y), actual.at(x, y));
}

void note(int x, int y, int amount, Comparison& comparison) {
  if (comparison.changed == 0) {
    comparison.left = x;
    comparison.top = y;
  }
  ++comparison.changed;
  comparison.left = std::min(comparison.left, x);
  comparison.top = std::min(comparison.top, y);
  comparison.right = std::max(comparison.right, x + 1);
  comparison.bottom = std::max(comparison.bottom, y + 1);
  if (amount > comparison.largest_difference) {
    comparison.largest_difference = amount;
    comparison.worst_x = x;
    comparison.worst_y = y;
  }
}

/// The pixel as it looks on white paper.
Color on_paper(Color color) {
  return mix(paper, {color.r, color.g, color.b, 255}, color.a / 255.0);
}

}  // namespace

std::string_view to_string(CompareVerdict verdict) {
  switch (verdict) {
    case CompareVerdict::identical:
      return "identical";
    case CompareVerdict::near_enough:
      return "near enough";
    case CompareVerdict::different:
      break;
  }
  return "different";
}

Comparison compare_images(const Image& expected, const Image& actual, const CompareLimits& limits) {
  Comparison comparison;
  if (expected == actual) return comparison;
  comparison.same_size = expected.width() == actual.width() && expected.height() == actual.height();
  const int width = std::max(expected.width(), actual.width());
  const int height = std::max(expected.height(), actual.height());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int amount = difference_at(expected, actual, x, y);
      if (amount > 0) note(x, y, amount, comparison);
    }
  }
  if (comparison.changed == 0) return comparison;
  comparison.share =
      static_cast<double>(comparison.changed) / (static_cast<double>(width) * height);
  const bool near_enough = comparison.same_size
                           && comparison.largest_difference <= limits.largest_difference
                           && comparison.share <= limits.largest_share;
  comparison.verdict = near_enough ? CompareVerdict::near_enough : CompareVerdict::different;
  return comparison;
}

std::string describe(const Comparison& comparison) {
  if (comparison.verdict == CompareVerdict::identical) return "identical";
  const std::string sizes = comparison.same_size ? "" : " (the sizes differ)";
  return fmt::format(
      "{}{}: {} pixels ({:.3g} %), largest difference {} at ({}, {}), within {}x{}+{}+{}",
      to_string(comparison.verdict), sizes, comparison.changed, 100.0 * comparison.share,
      comparison.largest_difference, comparison.worst_x, comparison.worst_y,
      comparison.right - comparison.left, comparison.bottom - comparison.top, comparison.left,
      comparison.top);
}

Image difference_picture(const Image& expected, const Image& actual, const CompareLimits& limits) {
  Image picture(std::max(expected.width(), actual.width()),
                std::max(expected.height(), actual.height()));
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const int amount = difference_at(expected, actual, x, y);
      if (amount > 0) {
        picture.set(x, y, amount > limits.largest_difference ? beyond : within);
        continue;
      }
      const auto grey = static_cast<std::uint8_t>(255.0 * brightness(on_paper(expected.at(x, y))));
      picture.set(x, y, mix(paper, {grey, grey, grey, 255}, 0.25));
    }
  }
  return picture;
}

Image side_by_side(const Image& expected,
                   const Image& actual,
                   const CompareLimits& limits,
                   Font& font) {
  constexpr int gap = 12;
  constexpr int title_height = 26;
  constexpr int widest = 16384;  // an image's limit
  const Image difference = difference_picture(expected, actual, limits);
  const std::array<const Image*, 3> parts{&expected, &actual, &difference};
  const std::array<std::string_view, 3> titles{"expected", "actual", "difference"};
  const int row_width = expected.width() + actual.width() + difference.width() + 4 * gap;
  const bool in_a_row = row_width <= widest;
  const int column_height =
      expected.height() + actual.height() + difference.height() + 3 * title_height + gap;
  Image sheet(in_a_row ? row_width : difference.width() + 2 * gap,
              in_a_row ? difference.height() + title_height + gap : column_height, rgb(0xDDE1E7));
  int x = gap;
  int y = title_height;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Image& part = *parts.at(i);
    Image opaque = part;
    for (int row = 0; row < part.height(); ++row) {
      for (int column = 0; column < part.width(); ++column) {
        opaque.set(column, row, on_paper(part.at(column, row)));
      }
    }
    paste(opaque, x, y, sheet);
    TextShape title;
    title.text = titles.at(i);
    title.baseline = {static_cast<float>(x), static_cast<float>(y - 8)};
    title.size = 13.0F;
    title.color = rgb(0x1B2430);
    internal::blend_text(title, {0, sheet.height()}, font, sheet);
    if (in_a_row) {
      x += part.width() + gap;
    } else {
      y += part.height() + title_height;
    }
  }
  return sheet;
}

}  // namespace wuerfel
