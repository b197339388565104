/// The parts of a frame in painting order; compose_frame calls them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/snapshot.h"
#include "render/picture/draw_list.h"
#include "render/picture/font.h"
#include "render/picture/frame_options.h"
#include "render/picture/labels.h"
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
  std::vector<Color> colors;  ///< of the boxes
  Font& font;
  Labels& labels;
  DrawList& list;

  bool has(Layer layer) const { return options.layers.has(layer); }
  Pixel pixel(const Vec2& world) const {
    const Vec2 p = view.to_pixel(world);
    return {static_cast<float>(p.x()), static_cast<float>(p.y())};
  }
  float weight(double pixels) const { return static_cast<float>(pixels * unit * fineness); }
  /// m
  double metres(double pixels) const { return pixels / view.pixels_per_metre; }
};

/// Kinds of arrows differ by form as well as by colour.
enum class ArrowForm {
  filled,  ///< forces
  hollow,  ///< forces that are not the only possible ones
  half,    ///< friction: half a head, on the left
  open,    ///< velocities: a head of two strokes
  twice,   ///< accelerations: two such heads
  dashed,  ///< a motion that is only thought of
};

/// An arrow waiting to be painted: all halos come before all arrows, so that no halo cuts a
/// neighbour.
struct PendingArrow {
  ArrowShape shape;
  ArrowForm form = ArrowForm::filled;
  bool cut = false;     ///< longer than it is drawn: broken near its tail
  double newton = 0.0;  ///< of a force that may have its number beside it
  double dot = 0.0;     ///< px, radius of a disc at its tail, where it belongs to a centre
};

void add_grid(const FrameParts& parts);
void add_ground(const FrameParts& parts);
void add_trails(const FrameParts& parts);
void add_ghosts(const FrameParts& parts);
void add_bodies(const FrameParts& parts);
void add_sides(const FrameParts& parts);
/// The triangle of p_i, p_j, p_k; hatched where it is negative.
void paint_side(const FrameParts& parts, const std::array<Pixel, 3>& corners, bool negative);
void add_rods(const FrameParts& parts);
void add_rod_forces(const FrameParts& parts);
void add_points(const FrameParts& parts);
float mass_radius(const FrameParts& parts, const SnapshotPoint& point);  ///< px
void add_links(const FrameParts& parts);
void add_mass_names(const FrameParts& parts);
void add_contacts(const FrameParts& parts);
void add_normals(const FrameParts& parts);
/// m, where the arrow of a normal ends.
Vec2 normal_tip(const FrameParts& parts, const SnapshotContact& contact);
/// The paper's symbols at contacts, sides and points.
void add_symbols(const FrameParts& parts);
/// Whether the contacts are few enough to have symbols; velocities are then those of their points.
bool shows_symbols(const FrameParts& parts);
void add_pressure(const FrameParts& parts);
/// m from the face, as far as the pressure of a joint is drawn.
double pressure_depth(const FrameParts& parts, const SnapshotJoint& joint);
void add_thrust(const FrameParts& parts);
constexpr double path_alpha = 0.34;
/// The same quietly, below the arrows: where forces run.
void add_paths(const FrameParts& parts);
void add_chains(const FrameParts& parts);
void add_impacts(const FrameParts& parts);
/// Paints all arrows of the layers; labels keep off them from then on.
std::vector<PendingArrow> add_arrows(const FrameParts& parts);
void add_names(const FrameParts& parts);
void add_hud(const FrameParts& parts);
/// The foot of the HUD alone.
void add_legend(const FrameParts& parts);
void add_whiskers(const FrameParts& parts);
/// `goes_on`: farther than it is drawn.
void paint_whisker(const FrameParts& parts, Pixel from, Pixel to, bool goes_on);
void add_causes(const FrameParts& parts);
void add_mechanism(const FrameParts& parts);
/// Of Snapshot::reason: where boxes would be that are moved, arrows of its fixes, and its words in the place of the HUD.
void add_moved_boxes(const FrameParts& parts);
void add_fixes(const FrameParts& parts);
void add_reason_text(const FrameParts& parts);

/// Of velocities and accelerations.
void add_motion_arrows(const FrameParts& parts, std::vector<PendingArrow>& arrows);
/// Arrows of the forces, and dots for those too small for one.
void add_joint_arrows(const FrameParts& parts, std::vector<PendingArrow>& arrows);
void add_contact_arrows(const FrameParts& parts, std::vector<PendingArrow>& arrows);
void add_weights(const FrameParts& parts, std::vector<PendingArrow>& arrows);
/// Numbers beside the arrows, where there is room.
void add_values(const FrameParts& parts, const std::vector<PendingArrow>& arrows);
/// Likewise beside the dots of weights and of forces corner by corner, as of free bodies: no force may be missing there.
void add_dot_values(const FrameParts& parts);

/// Numbers of joints whose arrows are not drawn.
void add_joint_values(const FrameParts& parts);

/// N; smaller forces are dots: their arrows would be shorter than a head.
double least_arrow(const FrameParts& parts);

constexpr double force_dot = 2.4;  ///< px, the radius of a dot
/// The dot of a force too small for an arrow.
void add_dot(const FrameParts& parts, Pixel place, Color color, double radius);

/// An arrow from `tail` to `tip` in the style's weights; small arrows get small heads.
ArrowShape styled_arrow(const FrameParts& parts, Pixel tail, Pixel tip, Color color);
/// Halos first, then the arrows.
void paint_arrows(const FrameParts& parts, const std::vector<PendingArrow>& arrows);

/// A thin arrow without a halo or a filled head: no force.
void paint_normal(const FrameParts& parts, Pixel tail, Pixel tip);

/// False where a box lies outside the picture.
bool visible(const FrameParts& parts, const SnapshotBox& box);

}  // namespace wuerfel::internal
