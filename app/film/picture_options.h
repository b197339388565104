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
#include "render/raster/rasteriser.h"

namespace wuerfel {

/// The length of force arrows, as told on the command line.
struct ForceScaleChoice {
  double metres_per_newton = 0.0;
  std::optional<ForceScale> whole;  ///< where the longest and the smallest arrow were told, too
};

/// What view and scales fit where they are not given.
enum class Fit { motion, instant };
std::string_view to_string(Fit fit);

struct PictureOptions {
  PixelSize size;
  double scale = 1.0;  ///< HiDPI factor on text and lines
  Layers layers = default_layers;
  Theme theme = Theme::light;
  Camera camera;
  std::optional<ForceScaleChoice> force_scale;  ///< none: fits the run, as do the next two
  std::optional<double> velocity_scale;         ///< m of arrow per m/s
  std::optional<double> acceleration_scale;     ///< m of arrow per m/s^2
  std::optional<double> rod_scale;              ///< N that make a rod as thick as it gets
  std::optional<ColorBy> color_by;  ///< none: its own for each body, the load in a crowd
  std::optional<double> color_top;  ///< N or m/s at the end of the scale of colours
  std::optional<Legend> legend;
  std::optional<double> average;  ///< s, that forces are averaged over; none: a film's interval
  Fit fit = Fit::motion;
  int head_lines = 1;                      ///< of text below the title
  int foot_lines = 1;                      ///< of text at the foot
  double explode = 0.0;                    ///< bodies are so much farther apart than they are
  PngEncoder encoder = PngEncoder::isa_l;  ///< changes files, not pictures
  Rasteriser rasteriser = Rasteriser::scan_lines;
};

/// What is drawn: of free bodies all forces, with weights and numbers, unless layers were `asked` for.
Layers drawn_layers(const PictureOptions& options, bool asked);

/// "S" or "S,LONGEST,SMALLEST". Throws UsageError.
ForceScaleChoice parse_force_scale(std::string_view text);

/// Where no height is told it follows from the scene, between these shares of the width.
constexpr double least_auto_height = 0.15;
constexpr double largest_auto_height = 1.25;
/// px: the height of pictures so wide, in which all of the motion just fits. Scales are fitted.
int auto_height(const PictureOptions& scaled, const Recording& motion);

/// Whether arrows of forces, or pressures, are drawn.
bool draws_forces(Layers layers);

/// True where only the whole motion can tell how the first picture looks.
bool needs_whole_motion(const PictureOptions& options);

/// True where pictures on the way to those asked for need more than poses: arrows that reach out of
/// bodies, which the view has room for.
bool needs_every_force(const PictureOptions& options);

/// The options with all questions answered that they left open, so that one picture can be drawn
/// alone as if it stood in the film.
PictureOptions fit_to_motion(PictureOptions options, const Recording& motion);
/// The same of scales alone, which don't depend on the size of the picture.
PictureOptions fit_scales(PictureOptions options, const MotionRange& range);

/// What the legend of fitted options has to say of pictures of this range.
Legend legend_of(const PictureOptions& fitted, const MotionRange& range);

/// What colours mean where it was not said: loads in a crowd.
ColorBy color_by(const PictureOptions& options, std::size_t cubes);

/// What pictures of fitted options are drawn by.
FrameOptions frame_options(const PictureOptions& fitted);

/// The picture of fitted options that `snapshot` is seen in.
View view_of(const PictureOptions& fitted, const Snapshot& snapshot);

/// The options as they would be written on the command line, every number in full.
std::string option_text(const PictureOptions& fitted);

/// What pictures of so many cubes need to know of the physics.
SnapshotRequest snapshot_request(const PictureOptions& options, std::size_t cubes);

/// How far pictures look back that stand for `interval` s of a motion, at a speed.
LookBack look_back(const PictureOptions& options, double interval, double speed);

/// How a film of these pictures is encoded.
AnimationSettings animation_settings(const PictureOptions& options, double fps, const Scene& scene);

}  // namespace wuerfel
