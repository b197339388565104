/// Style: colours and line weights of a theme. Lengths are in pixels of a picture of 1280x720;
/// frames scale them (see FrameOptions::unit).
#pragma once

#include <array>
#include <string_view>

#include "core/snapshot.h"
#include "render/picture/color.h"

namespace wuerfel {

enum class Theme { light, dark, print, transparent };

std::string_view to_string(Theme theme);

struct Style {
  Theme theme = Theme::light;
  Color background;
  Color ink;        ///< titles, ground line
  Color quiet_ink;  ///< second line of the HUD, labels
  Color ground;     ///< half-planes
  Color fixed;      ///< fixed boxes
  Color ground_line;
  Color hatch;
  Color grid;
  Color grid_axis;
  /// Bodies: Okabe-Ito without black, softened so that arrows stand out (print: greys).
  std::array<Color, 7> palette;
  double outline_shade = 0.0;  ///< how far an outline lies from its fill towards `outline`
  Color outline;
  Color rod;
  Color joint;
  Color mass;
  Color contact;      ///< force normal to a touching side
  Color friction;     ///< force along it
  Color tension;      ///< in a rod
  Color compression;  ///< in a rod
  Color velocity;
  Color acceleration;
  Color own_weight;  ///< m g of a cube
  Color thrust;
  Color whisker;
  Color mechanism;
  Color cause;
  Color chain;  ///< forces through a crowd
  Color normal;
  Color positive_side;  ///< triangle of Eq. (2), outside
  Color negative_side;  ///< ... inside
  Color halo;           ///< around arrows and text; fully transparent: no halo
  double outline_width = 1.6;
  double ground_line_width = 2.0;
  double arrow_width = 3.2;
  double arrow_head_length = 13.0;
  double arrow_head_width = 11.0;
  double halo_width = 1.5;
  double title_size = 19.0;
  double text_size = 14.0;
};

Style make_style(Theme theme);

/// The colour that a scene asks for, else the palette's.
Color body_color(const Style& style, const SnapshotBox& box);
Color force_color(const Style& style, ForceKind kind);

}  // namespace wuerfel
