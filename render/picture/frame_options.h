/// FrameOptions: what is the same for all frames of a run.
#pragma once

#include <vector>

#include "core/snapshot.h"
#include "render/picture/force_scale.h"
#include "render/picture/layers.h"
#include "render/picture/style.h"
#include "render/picture/view.h"

namespace wuerfel {

struct FrameOptions {
  Layers layers = default_layers;
  ForceScale force_scale;         ///< of force arrows; see ForceRange
  double metres_per_speed = 0.0;  ///< m per m/s, of velocity arrows; 0: none
  double full_rod_force = 0.0;  ///< N that makes a rod as thick as it gets; 0: the frame's largest
  /// Kinds named in the legend. Chosen once for a run, so that the legend stands still.
  std::vector<ForceKind> legend{ForceKind::contact};
  /// HiDPI factor on text, lines and arrow heads.
  double scale = 1.0;
};

/// Pixels per pixel of a 1280x720 picture: all weights grow with the picture, so that a poster
/// looks like a thumbnail, but never below what can be read.
double frame_unit(int width, int height, double scale);

/// What a fitted view keeps free for the HUD, or a plain margin without it.
Insets frame_insets(const Style& style, const FrameOptions& options, int width, int height);

}  // namespace wuerfel
