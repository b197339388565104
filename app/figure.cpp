#include <algorithm>

#include "app/accuracy.h"
#include "app/commands.h"
#include "app/still.h"
#include "render/error.h"
#include "render/files/output_file.h"

namespace wuerfel {

namespace {

// One time, or those of a strip: the ones given, else even ones up to the end.
std::vector<double> times_of(const FigureOptions& options, const Scene& scene) {
  const auto& strip = options.still.strip;
  if (!strip) return options.times.empty() ? std::vector<double>{0.0} : options.times;
  if (options.times.empty())
    return strip_times(strip->columns * strip->rows, options.until.value_or(scene.duration));
  std::vector<double> times = options.times;
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

std::vector<std::uint8_t> encode(const Still& still, const FigureOptions& options, Font& font) {
  if (const auto format = vector_format(options.output))
    return encode_vector_figure(still.page, *format, font, still.cells);
  return encode_png(draw_still(still), still.origin, options.still.picture.encoder);
}

}  // namespace

ExitCode figure(const FigureOptions& options) try {
  const Scene scene = read_scene(options.scene);
  StillOptions still_options = options.still;
  still_options.times = times_of(options, scene);
  OutputFile file(options.output);
  const StopSignal stop;
  Font font;
  const Still still = compose_still(scene, still_options, stop, font);
  file.write(encode(still, options, font));
  file.commit();
  return verdict_on_accuracy(still.audit);
} catch (const RenderError& error) {
  throw UsageError(error.what());
}

}  // namespace wuerfel
