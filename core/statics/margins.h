/// How nearly a scene stands or falls: load factors of a few load patterns (load_factor.h).
///
/// Where something rubs they say how far an equilibrium exists, which is necessary for standing but
/// not sufficient: Coulomb's law is not associated [Livesley 1978].
#pragma once

#include <optional>
#include <vector>

#include "core/statics/generators.h"
#include "core/statics/load_factor.h"
#include "core/statics/still_scene.h"

namespace wuerfel {

/// How far the ground may be tilted, or gravity turned, about any point, rad. Infinite: not below a
/// right angle. Negative: as far it has to be tilted the other way before it stands.
struct TiltMargin {
  double left = unbounded;
  double right = unbounded;
};

/// Of one cube. Ranges that exclude 0 say what would make a falling scene stand; empty ones
/// (is_empty) that nothing of the kind does.
struct BodyMargin {
  int cube = 0;
  LoadRange shift;  ///< m, of its weight, to the right of gravity
  LoadRange load;   ///< N, along gravity in the middle of its highest side; negative: a pull
  LoadRange move;   ///< m, of the cube with what it carries, along what it stands on
};

struct MarginRequest {
  bool tilt = true;
  bool load = true;
  bool shift = true;
  bool move = true;
  std::vector<int> cubes;  ///< empty: all
};

struct Margins {
  std::optional<TiltMargin> tilt;             ///< as given; none where no tilt makes it stand
  std::optional<TiltMargin> tilt_no_sliding;  ///< the same if nothing could slide [Heyman 1966]
  std::vector<BodyMargin> bodies;
  /// The least |shift| that changes the verdict, as a share of the smaller side of the cube it takes;
  /// negative where the scene falls; none where no shift does.
  std::optional<double> smallest;
  int weakest = -1;    ///< that cube
  double error = 0.0;  ///< the widest bracket, in the units of its margin
};

/// Of a scene in which nothing moves.
Margins find_margins(const StillScene& still,
                     const MotionSettings& settings,
                     const MarginRequest& request = {});

/// The cube whose weight may shift least, as a share of its smaller side.
struct Weakest {
  int cube = 0;
  double share = 0.0;
  LoadRange shift;  ///< m
};

/// Of a scene that stands; none where every weight may shift as it likes. Margins::smallest without
/// the margins of every cube.
std::optional<Weakest> find_weakest(const StillScene& still);

/// Tilts of which accelerations to the side, in g, are the tangents.
TiltMargin tilt_angles(const LoadRange& tangents);

/// The largest acceleration to the side, in g, at which forces exist: the tangent of the tilt. To the
/// right; its low end to the left.
LoadRange tilt_range(const StillScene& still, Sliding sliding);

}  // namespace wuerfel
