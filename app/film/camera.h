/// Where pictures look: at the whole motion, at a fixed part of the world, or after a body.
#pragma once

#include <string>
#include <string_view>

#include "core/snapshot.h"
#include "render/picture/view.h"

namespace wuerfel {

struct Camera {
  enum class Kind {
    fit,    ///< at all that is to be seen from the first frame to the last
    fixed,  ///< at `center`
    follow  ///< at the cube `body`, wherever it is
  };
  Kind kind = Kind::fit;
  Vec2 center = Vec2::Zero();  ///< m
  double width = 1.0;          ///< m, from left to right where `zoom` is 1
  std::string body;
  double zoom = 1.0;  ///< > 1: nearer
};

/// "fit", "x,y,width" in metres or "follow:NAME". Throws UsageError.
Camera parse_camera(std::string_view text);

/// The options that parse_camera and --zoom understand, with every number in full.
std::string option_text(const Camera& camera);

/// What a camera of any kind but `fit` sees of `snapshot` in a picture of this size. One that
/// follows a body sees 14 of its sides from left to right. Throws UsageError where there is no
/// such body.
View camera_view(const Camera& camera, const Snapshot& snapshot, int width, int height);

}  // namespace wuerfel
