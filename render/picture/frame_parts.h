/// The parts of a frame in painting order; compose_frame calls them.
#pragma once

#include <string>
#include <vector>

#include "core/snapshot.h"
#include "render/picture/draw_list.h"
#include "render/picture/font.h"
#include "render/picture/frame_options.h"
#include "render/picture/style.h"
#include "render/picture/view.h"

namespace wuerfel::internal {

/// What every part works with.
struct FrameParts {
  const Snapshot& snapshot;
  const View& view;
  const Style& style;
  const FrameOptions& options;
  double unit;      ///< px per px of a 1280x720 picture
  double fineness;  ///< 1; less where the cubes are so small that full line weights would bury them
  Font& font;
  DrawList& list;

  bool has(Layer layer) const { return options.layers.has(layer); }
  Pixel pixel(const Vec2& world) const {
    const Vec2 p = view.to_pixel(world);
    return {static_cast<float>(p.x()), static_cast<float>(p.y())};
  }
  float weight(double pixels) const { return static_cast<float>(pixels * unit * fineness); }
};

/// An arrow waiting to be painted: all halos come before all arrows, so that no halo cuts a
/// neighbour.
struct PendingArrow {
  ArrowShape shape;
  bool capped = false;
};

void add_grid(const FrameParts& parts);
void add_ground(const FrameParts& parts);
void add_trails(const FrameParts& parts);
void add_bodies(const FrameParts& parts);
void add_sides(const FrameParts& parts);
void add_rods(const FrameParts& parts);
void add_rod_forces(const FrameParts& parts);
void add_points(const FrameParts& parts);
void add_contacts(const FrameParts& parts);
void add_arrows(const FrameParts& parts);
void add_names(const FrameParts& parts);
void add_hud(const FrameParts& parts);

/// An arrow from `tail` to `tip` in the style's weights; small arrows get small heads.
ArrowShape styled_arrow(const FrameParts& parts, Pixel tail, Pixel tip, Color color);
/// Halos first, then the arrows; a capped one with a second head.
void paint_arrows(const FrameParts& parts, const std::vector<PendingArrow>& arrows);

/// True where the world point lies in a half-plane.
bool in_ground(const FrameParts& parts, const Vec2& world);

}  // namespace wuerfel::internal
