/// Still pictures: one instant of a motion, or a strip of several.
#pragma once

#include <optional>
#include <vector>

#include "app/cli/stop_signal.h"
#include "app/film/picture_options.h"
#include "app/film/timetable.h"
#include "app/words/language.h"
#include "core/scene/scene.h"
#include "core/settings.h"
#include "core/time/simulation.h"
#include "render/files/png.h"
#include "render/picture/draw_list.h"
#include "render/picture/film_strip.h"
#include "render/picture/font.h"
#include "render/raster/image.h"
#include "render/vector/vector_figure.h"

namespace wuerfel {

struct StillOptions {
  MotionSettings motion;
  PictureOptions picture;
  std::vector<double> times{0.0};  ///< s, ascending; one for each picture of a strip
  std::optional<StripGrid> strip;
  int legend_rows = 1;  ///< of a strip
  /// Frames of the film that the picture fits into: how often trails look where cubes are, too.
  FrameRate rate;
  std::optional<double> end;  ///< s, of that film; none: the scene's duration
  int ghosts = 0;             ///< earlier poses, evenly from the start
  /// Why the scene stands or falls is marked and told in this language: pictures of the start.
  std::optional<Language> why;
};

/// A still picture that any backend can draw.
struct Still {
  DrawList page;
  std::vector<PlacedList> cells;  ///< of a strip
  std::vector<PngText> origin;
  FigureTexts texts;  ///< of vector figures
  AccuracyWatch accuracy;
  int labels_left_out = 0;
  int legend_left_out = 0;  ///< entries
  Rasteriser rasteriser = Rasteriser::scan_lines;
  std::string hint;  ///< how more would be seen; see hint_at_specks
};

/// Simulates up to the last of the times. Throws SceneError, RenderError,
/// OutputError and Interrupted.
Still compose_still(const Scene& scene,
                    const StillOptions& asked,
                    const StopSignal& stop,
                    Font& font);

/// The pixels.
Image draw_still(const Still& still);

/// Throws UsageError unless the name ends in .png, .svg or .pdf.
void require_still_name(const std::string& name);

/// The file of that name, of any other a PNG; `width_mm` on paper, 0: by the pixels.
std::vector<std::uint8_t> encode_still(const Still& still,
                                       const std::string& name,
                                       PngEncoder encoder,
                                       Font& font,
                                       double width_mm = 0.0);

}  // namespace wuerfel
