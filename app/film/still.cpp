#include "app/film/still.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/core.h>

#include "app/film/origin.h"
#include "app/film/reason.h"
#include "app/film/recording.h"
#include "app/film/specks.h"
#include "app/film/strip.h"
#include "app/film/trails.h"
#include "core/scene/scene_parser.h"
#include "render/picture/compose_frame.h"
#include "render/picture/view.h"
#include "render/raster/renderer.h"

namespace wuerfel {

namespace {

// When to look: at the times asked for, and as often as a film would where trails are drawn or the
// picture has to fit into the film.
std::vector<TimetableEntry> instants_of(const StillOptions& options, const Scene& scene) {
  const double last = options.times.back();
  const PictureOptions& picture = options.picture;
  // A film of more frames than anybody looks at has no view and no scale to share.
  constexpr double most_frames = 1e6;
  const bool has_film = options.times.back() * options.rate.fps / options.rate.speed < most_frames;
  const bool whole = picture.fit == Fit::motion && needs_whole_motion(picture) && has_film;
  const double end = whole ? std::max(last, options.end.value_or(scene.duration)) : last;
  std::vector<double> frames;
  if (whole || picture.layers.has(Layer::trails)) frames = frame_times(end, options.rate);
  std::vector<TimetableEntry> instants = timetable(end, frames, options.times);
  if (whole) mark_scales(instants);
  for (TimetableEntry& instant : instants) {
    if (!whole) instant.scales = instant.frame || instant.sample;
    instant.bare = whole && !instant.scales && !instant.sample && !needs_every_force(picture);
  }
  return instants;
}

MotionSource source_of(const Scene& scene,
                       const StillOptions& options,
                       std::vector<TimetableEntry> instants,
                       const StopSignal& stop) {
  for (TimetableEntry& instant : instants)
    instant.frame = instant.frame || instant.sample;
  const PictureOptions& picture = options.picture;
  const SnapshotRequest request = snapshot_request(picture, scene.cubes.size());
  SnapshotRequest passing = request;
  passing.unique = passing.ranges = passing.causes = false;
  const LookBack back = look_back(picture, 0.0, options.rate.speed);
  return {scene, options.motion, with_looks(std::move(instants), back), request, passing,
          back,  stop,           Progress::style_for_stderr(false)};
}

// What the picture of an explanation marks and tells besides the scene.
void mark_reason(const Scene& scene, StillOptions& options, Snapshot& extras) {
  if (!options.why) return;
  const Explanation explanation = explain(scene, options.motion);
  for (const Layer layer : {Layer::causes, Layer::mechanism})
    if (reason_layers(explanation).has(layer)) options.picture.layers.insert(layer);
  add_reason(scene, explanation, *options.why, extras);
  options.picture.head_lines =
      std::max(1, static_cast<int>(std::ssize(extras.reason->headlines)) - 1);
  options.picture.foot_lines = std::max(1, static_cast<int>(std::ssize(extras.reason->advice)));
}

// A picture is the frame of a film, and its forces are those of such a frame.
StillOptions completed(const Scene& scene, const StillOptions& options) {
  StillOptions all = options;
  all.picture.color_by = color_by(options.picture, scene.cubes.size());
  if (!all.picture.average) {
    all.picture.average =
        options.picture.fit == Fit::motion ? options.rate.speed / options.rate.fps : 0.0;
  }
  return all;
}

/// Calls `show` with every snapshot, whether it stands on the way there, and whether it was asked for.
template <typename Show>
void for_each_shown(const Recording& motion,
                    const std::vector<TimetableEntry>& instants,
                    const Show& show) {
  auto instant = instants.begin();
  motion.for_each([&](const Snapshot& snapshot) {
    while (!instant->frame && !instant->sample)
      ++instant;
    show(snapshot, *instant++);
  });
}

MotionRange range_of_shown(const Recording& motion, const std::vector<TimetableEntry>& instants) {
  MotionRange range;
  for_each_shown(motion, instants,
                 [&range](const Snapshot& snapshot, const TimetableEntry& instant) {
                   if (instant.sample) range.include(snapshot);
                 });
  return range;
}

struct Cells {
  std::vector<DrawList> lists;
  std::string hint;  // of the last
};

/// One by one, the draw lists of the instants that were asked for, with the ghosts and the reason of `extras`.
Cells compose_cells(const Recording& motion,
                    const std::vector<TimetableEntry>& instants,
                    const PictureOptions& fitted,
                    const Snapshot& extras,
                    Font& font) {
  const Style style = make_style(fitted.theme);
  const FrameOptions frame = frame_options(fitted);
  const bool with_trails = fitted.layers.has(Layer::trails);
  Trails trails;
  Cells cells;
  for_each_shown(motion, instants, [&](const Snapshot& snapshot, const TimetableEntry& instant) {
    if (with_trails && instant.frame) trails.add(snapshot);
    if (!instant.sample) return;
    Snapshot shown = snapshot;
    shown.trails = trails.paths();
    shown.ghosts = extras.ghosts;
    if (extras.reason) {
      shown.reason = extras.reason;
      shown.causes = extras.causes;
      shown.mechanism = extras.mechanism;
    }
    const View view = view_of(fitted, shown);
    cells.lists.push_back(compose_frame(shown, view, style, frame, font));
    cells.hint = hint_at_specks(shown, view);
  });
  return cells;
}

std::string settings_text(const StillOptions& options, const PictureOptions& fitted) {
  PictureOptions page = fitted;
  page.size = options.picture.size;
  page.layers = options.picture.layers;
  std::string text = option_text(page);
  if (options.strip)
    text += fmt::format(" --strip {}x{}", options.strip->columns, options.strip->rows);
  if (options.ghosts > 0) text += fmt::format(" --ghosts {}", options.ghosts);
  if (options.why) text += fmt::format(" --why {}", to_string(*options.why));
  return text + " " + option_text(options.motion);
}

/// Cubes where they were at even times before.
std::vector<SnapshotBox> ghosts_of(const Scene& scene,
                                   const StillOptions& options,
                                   const StopSignal& stop) {
  std::vector<SnapshotBox> ghosts;
  if (options.ghosts == 0) return ghosts;
  std::vector<double> times(options.ghosts);
  for (int k = 0; k < options.ghosts; ++k)
    times[k] = options.times.back() * k / options.ghosts;
  const MotionSource source{scene, options.motion, timetable(times.back(), times, {}), {}, {}, {},
                            stop};
  source.show_frames([&ghosts](const Snapshot& snapshot) {
    std::ranges::copy_if(snapshot.boxes, std::back_inserter(ghosts),
                         [](const SnapshotBox& box) { return !box.fixed; });
  });
  return ghosts;
}

/// Boxes of `extras` in places where no frame has to have one.
std::vector<SnapshotBox> boxes_elsewhere(const Snapshot& first, const Snapshot& extras) {
  std::vector<SnapshotBox> boxes = extras.ghosts;
  if (!extras.reason) return boxes;
  for (const SnapshotReason::Fix& fix : extras.reason->fixes) {
    for (const int number : fix.moved)
      boxes.push_back(moved_by(first.boxes[number], fix.way));
  }
  return boxes;
}

FigureTexts texts_of(const Still& still, const Snapshot& first) {
  FigureTexts texts;
  texts.title = first.title;
  texts.description = "wuerfel: ";
  for (const PngText& text : still.origin)
    if (text.key == time_key) texts.description += "t = " + text.value + " s";
  texts.origin = still.origin;
  for (const SnapshotBox& box : first.boxes)
    texts.bodies.push_back(box.name);
  return texts;
}

/// What is known of a motion before it is drawn.
struct Filmed {
  const Scene& scene;
  const Recording& motion;
  const std::vector<TimetableEntry>& instants;
  const Snapshot& first;
  const Snapshot& extras;
};

/// The pictures, the legend, and the texts that go with them.
void draw(const Filmed& filmed, StillOptions options, Font& font, Still& still) {
  options.picture.size = size_of(options, filmed.motion);
  const auto picture =
      options.strip ? cell_options(options.picture, layout_of(options)) : options.picture;
  PictureOptions fitted = fit_to_motion(picture, filmed.motion);
  fitted.legend = legend_of(fitted, range_of_shown(filmed.motion, filmed.instants));
  Cells cells = compose_cells(filmed.motion, filmed.instants, fitted, filmed.extras, font);
  // What was asked for is no surprise, and bodies set free are not where the motion has them.
  const bool asked = options.picture.camera.zoom < 1.0 || options.picture.explode > 0.0;
  if (options.picture.camera.kind == Camera::Kind::fit && !asked) still.hint = cells.hint;
  still.labels_left_out = still.legend_left_out = 0;
  for (const DrawList& list : cells.lists) {
    still.labels_left_out += list.labels_left_out;
    still.legend_left_out += list.legend_left_out;
  }
  still.origin = {time_text(options.times)};
  for (PngText& text : origin_texts(settings_text(options, fitted), normalised_scene(filmed.scene)))
    still.origin.push_back(std::move(text));
  still.texts = texts_of(still, filmed.first);
  still.cells.clear();
  if (options.strip) {
    add_strip(options, fitted, filmed.first, std::move(cells.lists), font, still);
  } else {
    still.page = std::move(cells.lists.front());
  }
}

/// Room for a legend of more rows than the first look had: of strips the second, of pictures the third.
void fit_legend(const Filmed& filmed, StillOptions options, Font& font, Still& still) {
  constexpr int most = 3;  // of a strip
  int before = still.legend_left_out + 1;
  while (options.strip && still.legend_left_out > 0 && still.legend_left_out < before
         && options.legend_rows < most) {
    before = still.legend_left_out;
    ++options.legend_rows;
    draw(filmed, options, font, still);
  }
  if (!options.strip && still.page.legend_rows > 2) {
    options.picture.foot_lines = still.page.legend_rows;
    draw(filmed, options, font, still);
  }
}

}  // namespace

Still compose_still(const Scene& scene,
                    const StillOptions& asked,
                    const StopSignal& stop,
                    Font& font) {
  StillOptions options = completed(scene, asked);
  Snapshot extras;
  mark_reason(scene, options, extras);
  require_possible_steps(options.times.back(), options.motion);
  const std::vector<TimetableEntry> instants = instants_of(options, scene);
  const MotionSource source = source_of(scene, options, instants, stop);
  Recording motion(source);
  Still still;
  still.rasteriser = options.picture.rasteriser;
  Snapshot first;
  still.accuracy = source.show_frames([&](const Snapshot& snapshot) {
    if (first.boxes.empty()) first = snapshot;
    motion.add(snapshot);
  });
  extras.ghosts = ghosts_of(scene, options, stop);
  motion.add_besides(boxes_elsewhere(first, extras));

  const Filmed filmed{scene, motion, instants, first, extras};
  draw(filmed, options, font, still);
  fit_legend(filmed, options, font, still);
  return still;
}

Image draw_still(const Still& still) {
  Renderer renderer(still.rasteriser);
  Image image;
  renderer.draw(still.page, image);
  Image cell;
  for (const PlacedList& placed : still.cells) {
    renderer.draw(placed.list, cell);
    paste(cell, placed.x, placed.y, image);
  }
  return image;
}

void require_still_name(const std::string& name) {
  if (!has_suffix(name, ".png") && !vector_format(lower_case(name)))
    throw UsageError(fmt::format("-o: '{}' does not end in .png, .svg or .pdf", name));
}

std::vector<std::uint8_t> encode_still(
    const Still& still, const std::string& name, PngEncoder encoder, Font& font, double width_mm) {
  const auto format = vector_format(lower_case(name));
  if (!format) return encode_png(draw_still(still), still.origin, encoder);
  FigureTexts texts = still.texts;
  texts.width_mm = width_mm;
  return encode_vector_figure(still.page, *format, font, still.cells, texts);
}

}  // namespace wuerfel
