/// How pictures look.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/argument.h"
#include "app/film/camera.h"
#include "app/film/recording.h"
#include "core/scene/scene.h"
#include "core/time/simulation.h"
#include "render/files/animation.h"
#include "render/files/png.h"
#include "render/picture/force_scale.h"
#include "render/picture/frame_options.h"
#include "render/picture/layers.h"
#include "render/picture/style.h"

namespace wuerfel {

/// The length of force arrows, as told on the command line.
struct ForceScaleChoice {
  double metres_per_newton = 0.0;
  std::optional<ForceScale> whole;  ///< where the longest and the smallest arrow were told, too
};

struct PictureOptions {
  PixelSize size;
  double scale = 1.0;  ///< HiDPI factor on text and lines
  Layers layers = default_layers;
  Theme theme = Theme::light;
  Camera camera;
  std::optional<ForceScaleChoice> force_scale;  ///< none: fits the run, as do the next two
  std::optional<double> velocity_scale;         ///< m of arrow per m/s
  std::optional<double> rod_scale;              ///< N that make a rod as thick as it gets
  PngEncoder encoder = PngEncoder::isa_l;       ///< changes files, not pictures
};

/// "S" or "S,LONGEST,SMALLEST". Throws UsageError.
ForceScaleChoice parse_force_scale(std::string_view text);

/// True where only the whole motion can tell how the first picture looks.
bool needs_whole_motion(const PictureOptions& options);

/// The options with all questions answered that they left open, so that one picture can be drawn
/// alone as if it stood in the film.
PictureOptions fit_to_motion(PictureOptions options, const Recording& motion);

/// What pictures of fitted options are drawn by.
FrameOptions frame_options(const PictureOptions& fitted);

/// The picture of fitted options that `snapshot` is seen in.
View view_of(const PictureOptions& fitted, const Snapshot& snapshot);

/// The options as they would be written on the command line, every number in full.
std::string option_text(const PictureOptions& fitted);

/// What the layers need to know of the physics.
SnapshotRequest snapshot_request(Layers layers);

/// How a film of these pictures is encoded.
AnimationSettings animation_settings(const PictureOptions& options, double fps, const Scene& scene);

}  // namespace wuerfel
