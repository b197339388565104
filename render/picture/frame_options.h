/// FrameOptions: what is the same for all frames of a run.
#pragma once

#include "core/snapshot.h"
#include "render/picture/body_color.h"
#include "render/picture/force_scale.h"
#include "render/picture/layers.h"
#include "render/picture/style.h"
#include "render/picture/view.h"

namespace wuerfel {

struct FrameOptions {
  Layers layers = default_layers;
  ForceScale force_scale;                ///< of force arrows; see ForceRange
  double metres_per_speed = 0.0;         ///< m per m/s, of velocity arrows; 0: none
  double metres_per_acceleration = 0.0;  ///< m per m/s^2, of accelerations; 0: none
  double full_rod_force = 0.0;  ///< N that makes a rod as thick as it gets; 0: the frame's largest
  Legend legend{LegendEntry::contact};
  BodyColoring coloring;
  double explode =
      0.0;             ///< bodies are so much farther apart than they are, with all forces on them
  int head_lines = 1;  ///< of text below the title, that the view keeps free
  int foot_lines = 1;  ///< of text at the foot, that the view keeps free
  double interval = 0.0;  ///< s between frames: how many digits the time has; 0: a still picture
  /// HiDPI factor on text, lines and arrow heads.
  double scale = 1.0;
};

/// From this number of cubes on forces are chains through the bodies, as wide as they are large,
/// instead of arrows.
constexpr int crowd = 300;
bool is_crowd(const Snapshot& snapshot);

/// Whether a corner is behind its side by more than rounding: what may not be.
bool is_negative(const SnapshotSide& side);

/// Whether the layer forces tells where they run: the layer thrust does it louder.
bool shows_paths(const FrameOptions& options);

/// Where there is gravity, arrows of larger accelerations are cut: those of an impact's moment.
constexpr double most_gravities = 3.0;
/// What of an acceleration is drawn.
Vec2 shown_acceleration(const Vec2& acceleration, const Vec2& gravity);

/// px of a 1280x720 picture; a force whose arrow would be shorter is a dot.
constexpr double shortest_force_arrow = 8.0;

/// Pixels per pixel of a 1280x720 picture: all weights grow with the picture, so that a poster
/// looks like a thumbnail, but never below what can be read.
double frame_unit(int width, int height, double scale);

constexpr double line_height = 1.33;  ///< of text, as a share of its size

/// The parts of a HUD that a picture has room for: together they take no more than 40 % of its
/// height, or 60 % where they were asked to be larger.
struct HudParts {
  bool head = false;
  bool foot = false;
};
HudParts hud_parts(const Style& style, const FrameOptions& options, int width, int height);
/// px: the least height that has room for all of the HUD, as large as it is at `height`.
double height_for_hud(const Style& style, const FrameOptions& options, int width, int height);

constexpr double color_bar_width = 92.0;  ///< px of a 1280x720 picture, with its numbers

/// What a fitted view keeps free for the HUD, or a plain margin without it.
Insets frame_insets(const Style& style, const FrameOptions& options, int width, int height);

}  // namespace wuerfel
