/// compose_frame: a snapshot becomes a draw list. No pixel is touched here, and no backend is
/// known.
#pragma once

#include "core/snapshot.h"
#include "render/picture/draw_list.h"
#include "render/picture/font.h"
#include "render/picture/frame_options.h"
#include "render/picture/style.h"
#include "render/picture/view.h"

namespace wuerfel {

/// A function of its arguments alone. `font` measures the texts.
DrawList compose_frame(const Snapshot& snapshot,
                       const View& view,
                       const Style& style,
                       const FrameOptions& options,
                       Font& font);

/// The legend of pictures in this style and with these options alone, at the foot of a page of
/// `view`'s size: `view` has their scale, `unit` is the page's.
DrawList compose_legend(const Snapshot& snapshot,
                        const View& view,
                        double unit,
                        const Style& style,
                        const FrameOptions& options,
                        Font& font);

}  // namespace wuerfel
