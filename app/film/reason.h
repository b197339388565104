/// What of an explanation goes into a picture.
#pragma once

#include "app/words/explanation.h"
#include "core/snapshot.h"
#include "render/picture/layers.h"

namespace wuerfel {

/// The layers that mark what an explanation says.
Layers reason_layers(const Explanation& explanation);

/// The first two causes, or the mechanism where no part fails alone, and the smallest move and force that
/// mend it; of what stands its weakest cube. In words, and as marks of the snapshot.
void add_reason(const Scene& scene,
                const Explanation& explanation,
                Language language,
                Snapshot& snapshot);

}  // namespace wuerfel
