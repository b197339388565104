/// Film strips: several instants on one sheet, and how large sheets are.
#pragma once

#include <vector>

#include "app/film/recording.h"
#include "app/film/still.h"

namespace wuerfel {

/// Where the frames of a strip are on its sheet.
StripLayout layout_of(const StillOptions& options);

/// Frames of a strip are smaller, and their captions take the place of the HUD.
PictureOptions cell_options(const PictureOptions& page, const StripLayout& layout);

/// Where no height was told: that of the scene, or of a strip whose frames have the scene's shape.
PixelSize size_of(const StillOptions& options, const Recording& motion);

/// Puts frames, captions and the legend on the sheet.
void add_strip(const StillOptions& options,
               const PictureOptions& fitted,
               const Snapshot& first,
               std::vector<DrawList> lists,
               Font& font,
               Still& still);

}  // namespace wuerfel
