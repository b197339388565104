/// Literal snapshots: pictures drawn from them cannot be changed by the physics.
#pragma once

#include "core/snapshot.h"
#include "render/picture/frame_options.h"
#include "render/picture/layers.h"
#include "render/picture/style.h"
#include "render/picture/view.h"

namespace wuerfel::test {

/// A small pyramid on a floor beside a slope, two falling cubes and a shelf, with everything that a
/// layer can show.
Snapshot pyramid_snapshot();

/// The pyramid with ranges of some forces, two parts that fail and the motion in which they do.
Snapshot failing_snapshot();

/// Two cubes apart, with the triangles of Eq. (2): one corner outside, one inside (Figures 3 and 4
/// of the paper).
Snapshot two_cubes_snapshot();

/// Options for these snapshots, with arrow scales that suit them.
FrameOptions literal_options(Layers layers);

/// The whole of a literal snapshot in a picture of this size.
View literal_view(const Snapshot& snapshot,
                  const Style& style,
                  const FrameOptions& options,
                  int width,
                  int height);

}  // namespace wuerfel::test
