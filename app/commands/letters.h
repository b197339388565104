/// Letters that the font of the pictures does not have.
#pragma once

#include "app/cli/streams.h"
#include "core/scene/scene.h"
#include "render/picture/layers.h"

namespace wuerfel {

/// Notes letters of the title and of names that are drawn as boxes, and scripts that run from right
/// to left, which are drawn from left to right.
void note_letters(const Scene& scene, Layers layers, Notes& notes);

}  // namespace wuerfel
