#include "render/files/animation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "render/error.h"
#include "render/files/apng_writer.h"
#include "render/files/ffmpeg_writer.h"

namespace wuerfel {
namespace {

constexpr std::array<std::string_view, 4> suffixes{".mp4", ".webm", ".gif", ".apng"};
constexpr std::size_t palette_size = 255;  ///< one of 256 is kept for transparency

/// The same letters, small or large.
bool ends_with(std::string_view path, std::string_view suffix) {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return path.size() >= suffix.size()
         && std::ranges::equal(path.substr(path.size() - suffix.size()), suffix, {}, small);
}

/// `steps` colours between two, without the ends: an antialiased edge.
void add_edge(Color from, Color to, int steps, std::vector<Color>& palette) {
  for (int i = 1; i <= steps; ++i)
    palette.push_back(mix(from, to, i / (steps + 1.0)));
}

}  // namespace

bool is_animation_path(const std::string& path) {
  return std::ranges::any_of(suffixes,
                             [&path](std::string_view suffix) { return ends_with(path, suffix); });
}

std::unique_ptr<AnimationWriter> make_animation_writer(const std::string& path,
                                                       const AnimationSettings& settings) {
  if (ends_with(path, ".apng")) return std::make_unique<internal::ApngWriter>(path, settings);
  if (ends_with(path, ".mp4"))
    return std::make_unique<internal::FfmpegWriter>(path, internal::FilmFormat::mp4, settings);
  if (ends_with(path, ".webm"))
    return std::make_unique<internal::FfmpegWriter>(path, internal::FilmFormat::webm, settings);
  if (ends_with(path, ".gif"))
    return std::make_unique<internal::FfmpegWriter>(path, internal::FilmFormat::gif, settings);
  throw RenderError("no film format has the suffix of " + path
                    + "; known: .mp4, .webm, .gif, .apng");
}

std::vector<Color> animation_palette(const Style& style, const std::vector<Color>& bodies) {
  const Color background = with_alpha(style.background, 1.0);
  std::vector<Color> fills(style.palette.begin(), style.palette.end());
  fills.insert(fills.end(), bodies.begin(), bodies.end());
  fills.push_back(style.fixed);
  fills.push_back(style.ground);
  const std::array strokes{
      style.contact,   style.friction,     style.tension,       style.compression,  style.velocity,
      style.normal,    style.acceleration, style.own_weight,    style.thrust,       style.whisker,
      style.mechanism, style.cause,        style.positive_side, style.negative_side};
  std::vector<Color> palette{background,  style.ink,  style.quiet_ink, style.ground_line,
                             style.hatch, style.grid, style.grid_axis, style.rod,
                             style.joint, style.mass};
  palette.insert(palette.end(), strokes.begin(), strokes.end());
  for (const Color fill : fills) {
    const Color outline = mix(fill, style.outline, style.outline_shade);
    palette.push_back(fill);
    palette.push_back(outline);
    add_edge(fill, outline, 3, palette);
    add_edge(outline, background, 3, palette);
  }
  add_edge(background, style.ink, 6, palette);
  add_edge(style.ground, style.quiet_ink, 5, palette);
  for (const Color stroke : strokes)
    add_edge(stroke, background, 4, palette);
  for (const Color fill : fills)
    add_edge(fill, background, 2, palette);
  for (Color& color : palette)
    color.a = 255;
  std::vector<Color> distinct;
  for (const Color color : palette) {
    if (std::ranges::find(distinct, color) == distinct.end()) distinct.push_back(color);
  }
  distinct.resize(std::min(distinct.size(), palette_size));
  return distinct;
}

}  // namespace wuerfel
