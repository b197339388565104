/// View: which part of the world a picture shows. World: metres, y up; picture: pixels, y down, (0,
/// 0) the upper left corner of the upper left pixel.
#pragma once

#include <array>

#include "core/snapshot.h"
#include "render/picture/force_scale.h"

namespace wuerfel {

/// The four corners of a posed box, m.
std::array<Vec2, 4> corners(const SnapshotBox& box);
/// Unit vector along its width.
Vec2 axis_of(const SnapshotBox& box);

/// A box that has followed its motion so far that the corner that moves most has moved by `reach` m.
SnapshotBox moved_by(const SnapshotBox& box, const SnapshotMotion& motion, double reach);
SnapshotBox moved_by(const SnapshotBox& box, const Vec2& way);
/// m, that pictures move it by.
double motion_scale(const Snapshot& snapshot);

/// An axis-parallel rectangle of the world that grows around what it is given; empty at first.
struct Bounds {
  Vec2 min = Vec2::Constant(1e300);
  Vec2 max = Vec2::Constant(-1e300);

  bool empty() const { return min.x() > max.x(); }
  Vec2 size() const { return empty() ? Vec2(Vec2::Zero()) : Vec2(max - min); }
  void include(const Vec2& point);
  void include(const SnapshotBox& box);
  /// All boxes, the tips of force arrows at this scale (m/N, 0: no arrows) and the ground below or
  /// beside them where it is near, with room for the longest arrow of a joint: whatever pushes there,
  /// the view is the same.
  void include(const Snapshot& snapshot, const ForceScale& force_scale = {});
};

/// Pixels kept free at the borders of a picture.
struct Insets {
  double left = 0.0;
  double top = 0.0;
  double right = 0.0;
  double bottom = 0.0;
};

struct View {
  int width = 1280;            ///< px
  int height = 720;            ///< px
  Vec2 center = Vec2::Zero();  ///< m, in the middle of the picture
  double pixels_per_metre = 100.0;
  friend bool operator==(const View&, const View&) = default;

  Vec2 to_pixel(const Vec2& world) const {
    return {0.5 * width + (world.x() - center.x()) * pixels_per_metre,
            0.5 * height - (world.y() - center.y()) * pixels_per_metre};
  }
  Vec2 to_world(const Vec2& pixel) const {
    return {center.x() + (pixel.x() - 0.5 * width) / pixels_per_metre,
            center.y() - (pixel.y() - 0.5 * height) / pixels_per_metre};
  }
};

/// The largest view that keeps `bounds` inside the insets, centred from left to right, standing on
/// the lower inset where there is height to spare. Bounds that are empty or a point show one metre
/// around them.
View fit_view(const Bounds& bounds, int width, int height, const Insets& insets);

/// `center` in the middle, `world_width` metres from left to right. Throws RenderError unless the
/// width is positive and all is finite.
View fixed_view(const Vec2& center, double world_width, int width, int height);

}  // namespace wuerfel
