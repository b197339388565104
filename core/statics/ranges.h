/// Which forces are possible: of each contact, and of each face on which two bodies touch, over all
/// forces that give the scene the accelerations it has.
///
/// The resultant of a face, its centre of pressure and their ranges depend on nothing but the bodies;
/// forces at corners do on where the corners are.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/statics/load_factor.h"
#include "core/statics/still_scene.h"

namespace wuerfel {

/// The contacts of two bodies with parallel normals.
struct Interface {
  int on = 0;  ///< the normal points into this body
  int from = 0;
  Vec2 normal = Vec2::UnitY();
  Vec2 middle = Vec2::Zero();  ///< m, of the face
  double length = 0.0;         ///< m, 0 where it is a corner
  double force = 0.0;          ///< N, on `on` along the normal
  double tangential = 0.0;     ///< N, along the normal turned left
  LoadRange force_range;       ///< N; empty where it is not known
  std::optional<Vec2> center;  ///< m, of pressure; none where nothing presses
  /// m, of the centre of pressure along the normal turned left, from the middle; empty where nothing
  /// can press.
  LoadRange center_range = no_load;
  /// Of the centre of pressure, as a share of half the length: 1 at an end.
  std::optional<double> eccentricity;
};

struct ForceRanges {
  std::vector<LoadRange>
      contacts;  ///< N, one per contact, island by island; empty where not asked for, or not known
  std::vector<Interface> interfaces;  ///< in the order of their first contact
  int degree = 0;  ///< of hyperstaticity: the dimension of the set of all such forces
  double error = 0.0;
};

struct RangeRequest {
  std::vector<int> cubes{};  ///< ranges at these only; empty: all
  bool degree = true;
  int threads = 1;                               ///< the answer has the same bits for any number
  std::function<void(double share)> progress{};  ///< told by the calling thread how much is done
};

/// Of a scene in which nothing moves.
ForceRanges find_ranges(const StillScene& still, const RangeRequest& request = {});

}  // namespace wuerfel
