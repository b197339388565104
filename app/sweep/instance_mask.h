/// Which body each pixel shows.
#pragma once

#include <cstdint>
#include <span>

#include "app/sweep/gray_png.h"
#include "core/snapshot.h"
#include "render/picture/view.h"

namespace wuerfel {

/// The number of the cube that holds the middle of the pixel; 0: none does (air and ground). Exact,
/// without blended edges. One number per cube, in the order of the scene.
NumberImage number_mask(const Snapshot& snapshot,
                        const View& view,
                        std::span<const std::uint16_t> numbers);

/// The same with 1, 2, 3, ... At most 65535 cubes.
NumberImage instance_mask(const Snapshot& snapshot, const View& view);

}  // namespace wuerfel
