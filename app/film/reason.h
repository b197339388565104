/// What of an explanation goes into a picture.
#pragma once

#include "app/words/explanation.h"
#include "core/snapshot.h"

namespace wuerfel {

/// The first cause, or the mechanism, and the smallest move and force that mend it.
SnapshotReason picture_reason(const Scene& scene,
                              const Explanation& explanation,
                              Language language);

}  // namespace wuerfel
