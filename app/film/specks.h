/// Motions so wide that nothing of their bodies is seen.
#pragma once

#include <string>

#include "core/snapshot.h"
#include "render/picture/view.h"

namespace wuerfel {

/// A hint where the cubes are specks in a view that fits the motion: how many pixels they have, and
/// the option that shows the largest group of them. Empty where they are seen, or where no smaller
/// view would show more.
std::string hint_at_specks(const Snapshot& snapshot, const View& view);

}  // namespace wuerfel
