#include "app/film/still.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "app/film/origin.h"
#include "app/film/recording.h"
#include "app/film/trails.h"
#include "core/scene/scene_parser.h"
#include "render/picture/compose_frame.h"
#include "render/raster/renderer.h"

namespace wuerfel {

namespace {

std::optional<StripLayout> layout_of(const StillOptions& options) {
  if (!options.strip) return std::nullopt;
  const auto [width, height] = options.picture.size;
  return strip_layout(*options.strip, width, height, options.picture.scale);
}

// Frames of a strip are smaller, and their captions take the place of the HUD.
PictureOptions cell_options(const PictureOptions& page, const StripLayout& layout) {
  PictureOptions cell = page;
  cell.size = {layout.cell_width, layout.cell_height};
  cell.layers.erase(Layer::hud);
  return cell;
}

// When to look: at the times asked for, and as often as a film would where trails are drawn or the
// picture has to fit into the film.
std::vector<Instant> instants_of(const StillOptions& options, const Scene& scene) {
  const double last = options.times.back();
  const PictureOptions& picture = options.picture;
  const bool whole = picture.fit == Fit::motion && needs_whole_motion(picture);
  const double end = whole ? std::max(last, options.end.value_or(scene.duration)) : last;
  std::vector<double> frames;
  if (whole || picture.layers.has(Layer::trails)) frames = frame_times(end, options.rate);
  return timetable(end, frames, options.times);
}

MotionSource source_of(const Scene& scene,
                       const StillOptions& options,
                       std::vector<Instant> instants,
                       const StopSignal& stop) {
  for (Instant& instant : instants)
    instant.frame = instant.frame || instant.sample;
  const PictureOptions& picture = options.picture;
  const SnapshotRequest request = snapshot_request(picture, scene.cubes.size());
  const LookBack back = look_back(picture, 0.0, options.rate.speed);
  return {scene,
          options.motion,
          with_looks(std::move(instants), request.joints ? back.average : 0.0),
          request,
          back,
          stop,
          Progress::style_for_stderr(false)};
}

// A picture is the frame of a film, and its forces are those of such a frame.
StillOptions completed(const Scene& scene, const StillOptions& options) {
  StillOptions all = options;
  all.picture.color_by = color_by(options.picture, scene.cubes.size());
  if (!all.picture.average)
    all.picture.average =
        options.picture.fit == Fit::motion ? options.rate.speed / options.rate.fps : 0.0;
  return all;
}

/// One by one, the draw lists of the instants that were asked for.
std::vector<DrawList> compose_cells(const Recording& motion,
                                    const std::vector<Instant>& instants,
                                    const PictureOptions& fitted,
                                    Font& font) {
  const Style style = make_style(fitted.theme);
  const FrameOptions frame = frame_options(fitted);
  Trails trails;
  std::vector<DrawList> lists;
  auto instant = instants.begin();
  motion.for_each([&](const Snapshot& snapshot) {
    while (!instant->frame && !instant->sample)
      ++instant;
    const auto [t, on_the_way, asked_for, look] = *instant++;
    if (on_the_way) trails.add(snapshot);
    if (!asked_for) return;
    Snapshot shown = snapshot;
    shown.trails = trails.paths();
    lists.push_back(compose_frame(shown, view_of(fitted, shown), style, frame, font));
  });
  return lists;
}

std::string settings_text(const StillOptions& options, const PictureOptions& fitted) {
  PictureOptions page = fitted;
  page.size = options.picture.size;
  page.layers = options.picture.layers;
  std::string text = option_text(page);
  if (options.strip)
    text += fmt::format(" --strip {}x{}", options.strip->columns, options.strip->rows);
  return text + " " + option_text(options.motion);
}

}  // namespace

Still compose_still(const Scene& scene,
                    const StillOptions& asked,
                    const StopSignal& stop,
                    Font& font) {
  const StillOptions options = completed(scene, asked);
  const std::optional<StripLayout> layout = layout_of(options);
  require_possible_steps(options.times.back(), options.motion);
  const std::vector<Instant> instants = instants_of(options, scene);
  const MotionSource source = source_of(scene, options, instants, stop);
  Recording motion(source);
  Still still;
  still.accuracy =
      source.show_frames([&motion](const Snapshot& snapshot) { motion.add(snapshot); });

  const PictureOptions fitted =
      fit_to_motion(layout ? cell_options(options.picture, *layout) : options.picture, motion);
  std::vector<DrawList> lists = compose_cells(motion, instants, fitted, font);

  still.origin.push_back(time_text(options.times));
  for (PngText& text : origin_texts(settings_text(options, fitted), normalised_scene(scene)))
    still.origin.push_back(std::move(text));
  if (!layout) {
    still.page = std::move(lists.front());
    return still;
  }
  std::vector<std::string> captions;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const CellPlace place = cell_place(*layout, i);
    captions.push_back(fmt::format("t = {:.3f} s", options.times[i]));
    still.cells.push_back({std::move(lists[i]), place.x, place.y});
  }
  still.page = strip_page(captions, *layout, make_style(fitted.theme));
  return still;
}

Image draw_still(const Still& still) {
  Renderer renderer;
  Image image;
  renderer.draw(still.page, image);
  Image cell;
  for (const PlacedList& placed : still.cells) {
    renderer.draw(placed.list, cell);
    paste(cell, placed.x, placed.y, image);
  }
  return image;
}

}  // namespace wuerfel
