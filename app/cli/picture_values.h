/// What pictures look like as people write it on the command line: themes, layers, strips, windows.
#pragma once

#include <string_view>

#include "core/geometry/vec2.h"
#include "render/picture/film_strip.h"
#include "render/picture/layers.h"
#include "render/picture/style.h"

namespace wuerfel {

/// "light". All readers here throw UsageError; unknown names get a suggestion.
Theme parse_theme(std::string_view text);

/// "cubes,forces,hud"; blanks beside the commas don't matter.
Layers parse_layers(std::string_view text);

/// "contact,cut".
Legend parse_legend(std::string_view text);

/// "4x2", columns by rows.
StripGrid parse_strip(std::string_view text);

/// Throws UsageError where lines and text of that scale could not be drawn or read.
void require_scale(std::string_view name, double scale);

/// A part of the world.
struct WorldWindow {
  Vec2 center = Vec2::Zero();  ///< m
  double width = 1.0;          ///< m, from left to right
};

/// "x,y,width": three finite numbers, the last greater than 0.
WorldWindow parse_window(std::string_view text);

}  // namespace wuerfel
