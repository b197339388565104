#include <algorithm>
#include <cmath>
#include <memory>
#include <unistd.h>

#include <fmt/core.h>

#include "app/cli/argument.h"
#include "app/cli/option_groups.h"
#include "app/commands/commands.h"
#include "app/commands/idle_options.h"
#include "app/commands/letters.h"
#include "app/film/still.h"
#include "app/output/accuracy.h"
#include "app/output/text_output.h"

namespace wuerfel {

namespace {

struct FigureOptions {
  SceneChoice scene;
  StillOptions still;           ///< but for the times
  std::vector<double> times;    ///< s; none: the start, or even times of a strip
  std::optional<double> until;  ///< s, end of even times; none: the scene's duration
  std::string output;
  double width_mm = 0.0;  ///< on paper; 0: by the pixels
};

constexpr double most_pictures = 1e4;  // of a strip: none is as large

void require_still(const FigureOptions& asked) {
  const std::string& name = asked.output;
  if (name == "-" && isatty(STDOUT_FILENO) != 0)
    throw UsageError("-o: a picture is nothing for a terminal: name a file");
  if (name != "-") require_still_name(name);
  const auto& strip = asked.still.strip;
  const double room =
      strip ? static_cast<double>(strip->columns) * static_cast<double>(strip->rows) : 1.0;
  if (room > most_pictures) {
    throw UsageError(
        fmt::format("--strip: {:.0f} pictures are more than {:.0f}", room, most_pictures));
  }
  if (static_cast<double>(asked.times.size()) > room) {
    throw UsageError(
        strip ? fmt::format("-t: {} times do not fit into a strip of {}", asked.times.size(), room)
              : "-t: several times need a --strip such as 4x2");
  }
  if (asked.width_mm > 0.0 && !vector_format(lower_case(name)))
    throw UsageError("--width: a picture in pixels has no width on paper; .svg and .pdf have");
  if (strip && asked.still.ghosts > 0)
    throw UsageError("--ghosts: a --strip shows other times itself");
  if (asked.until && (!strip || !asked.times.empty()))
    throw UsageError("--until is the end of a --strip whose times are not given");
}

// One time, or those of a strip: the ones given, else even ones up to the end.
std::vector<double> times_of(const FigureOptions& asked, const Scene& scene) {
  const auto& strip = asked.still.strip;
  if (!strip) return asked.times.empty() ? std::vector<double>{0.0} : asked.times;
  if (asked.times.empty())
    return strip_times(strip->columns * strip->rows, asked.until.value_or(scene.duration));
  std::vector<double> times = asked.times;
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

// Letters that are fine on a screen are specks in a column of a journal.
void note_small_print(const Still& still, const FigureOptions& asked, Notes& notes) {
  constexpr double readable = 5.0;  // pt
  constexpr double largest_scale = 8.0;
  double least = 1e300;
  const auto look = [&least](const DrawList& list) {
    for (const TextShape& text : list.texts)
      least = std::min(least, static_cast<double>(text.size));
  };
  look(still.page);
  for (const PlacedList& cell : still.cells)
    look(cell.list);
  const double points = least * asked.width_mm / still.page.width * 72.0 / 25.4;
  if (asked.width_mm <= 0.0 || points >= readable || least == 1e300) return;
  const double scale = std::ceil(10.0 * asked.still.picture.scale * readable / points) / 10.0;
  const std::string remedy =
      scale > largest_scale ? std::string("take a larger --width")
                            : fmt::format("--scale {:.1f} makes them {:.0f} pt", scale, readable);
  notes.add(fmt::format("letters of {:.1f} pt on paper are hard to read: {}", points, remedy));
}

ExitCode figure(const FigureOptions& asked, const Options& options) {
  require_still(asked);
  Notes notes;
  require_effect(options, asked.still.motion);
  note_idle_picture_options(options, asked.still.picture.layers, notes);
  if (vector_format(lower_case(asked.output)))
    note_idle(options, {"--encoder", "--rasteriser"}, "for .svg and .pdf", notes);
  const Scene scene = read_scene(asked.scene);
  const bool all_told =
      !note_what_is_left_out(options, scene, asked.still.motion.integrator, notes);
  note_letters(scene, asked.still.picture.layers, notes);
  note_crowd(scene, asked.still.picture.layers, notes);
  note_idle_colors(options, color_by(asked.still.picture, scene.cubes.size()), notes);
  StillOptions still_options = asked.still;
  still_options.times = times_of(asked, scene);
  if (asked.still.picture.fit == Fit::instant && still_options.times == std::vector{0.0}) {
    const std::string where = "for the start of a scene with --fit instant";
    // One without friction shows other forces at the start as well.
    if (all_told) note_idle(options, {"--integrator"}, where, notes);
    note_idle(options, {"--tolerance", "--step"}, where, notes);
  }
  still_options.picture.layers = drawn_layers(asked.still.picture, options.given("--layers"));
  if (asked.until) still_options.end = asked.until;
  // A strip has the scene's shape.
  if (asked.still.strip && !options.given("--size")) still_options.picture.size.height = 0;
  TextOutput output(asked.output);
  const StopSignal stop;
  Font font;
  const Still still = compose_still(scene, still_options, stop, font);
  note_labels_left_out(still.labels_left_out, notes);
  // A strip has a title and a legend whatever its size.
  if (!still_options.strip)
    note_hud(still_options.picture, {still.page.width, still.page.height}, notes);
  if (still.legend_left_out > 0) {
    notes.add(left_out(still.legend_left_out, "entry of the legend", "entries of the legend")
              + ": take a larger --size, a smaller --scale or fewer --layers");
  }
  if (!still.hint.empty()) notes.add(still.hint);
  note_small_print(still, asked, notes);
  output.write(
      encode_still(still, asked.output, asked.still.picture.encoder, font, asked.width_mm));
  output.finish();
  return still.accuracy.verdict(notes);
}

}  // namespace

Action declare_figure(Options& options) {
  auto asked = std::make_shared<FigureOptions>();
  add_scene(options, asked->scene);
  options.value("-t,--time", "T1,T2,..", "instant in s, several for a strip [0]",
                [asked](const std::string& text) {
                  for (const std::string& time : split_list(text))
                    asked->times.push_back(parse_time("-t", time));
                });
  add_strip_option(options, asked->still.strip);
  options.single("--until", "T", "end of the even times of a strip in s [the scene's duration]",
                 [asked](const std::string& text) { asked->until = parse_time("--until", text); });
  options.required_text(
      "-o,--output", "FILE",
      "picture: .png, sharp at any size .svg .pdf, or - for a PNG on standard output",
      asked->output);
  add_picture_options(options, asked->still.picture);
  options.single(
      "--width", "LENGTH", "width on paper of .svg and .pdf, as 84mm [96 pixels to the inch]",
      [asked](const std::string& text) { asked->width_mm = parse_paper_length("--width", text); });
  add_ghosts_option(options, asked->still.ghosts);
  add_choice(options, "--fit", "what view and scales fit: the whole motion, as in its film, or",
             asked->still.picture.fit);
  add_encoder_option(options, asked->still.picture.encoder);
  add_motion_options(options, asked->still.motion);
  add_memory_option(options);
  return [asked, &options](const Stopwatch&) { return figure(*asked, options); };
}

}  // namespace wuerfel
