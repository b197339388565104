/// Which body each pixel shows.
#pragma once

#include "app/sweep/gray_png.h"
#include "core/snapshot.h"
#include "render/picture/view.h"

namespace wuerfel {

/// The number of the cube that holds the middle of the pixel, from 1 in the order of the scene; 0:
/// none does (air and ground). Exact, without blended edges. At most 65535 cubes.
NumberImage instance_mask(const Snapshot& snapshot, const View& view);

}  // namespace wuerfel
