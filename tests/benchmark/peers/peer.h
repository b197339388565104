/// A physics engine of other people, driven on our scenes.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/model/state.h"
#include "core/scene/scene.h"

namespace wuerfel::bench {

/// A scene in the hands of an engine; the step is fixed when it is made.
class PeerWorld {
 public:
  virtual ~PeerWorld() = default;
  virtual void step() = 0;
  /// One per cube, in the order of the scene.
  [[nodiscard]] virtual State states() const = 0;
};

/// A configuration of an engine. `prepare` does what is done once for a scene and is not timed
/// (only MuJoCo has such work: it compiles a model); what it returns makes a world, which is timed.
struct Peer {
  using Maker = std::function<std::unique_ptr<PeerWorld>()>;
  std::string engine;  ///< with its version
  std::string method;
  std::size_t most_cubes = 0;  ///< above, a run takes minutes
  std::function<Maker(const Scene& scene, double step)> prepare;
  bool rubs = true;  ///< takes the friction of scenes
};

/// A plane as the engines get it: a fixed box, its upper face on the plane around the plane's
/// point.
inline SceneFixed box_of_plane(const ScenePlane& plane) {
  constexpr double length = 80.0;  // m
  constexpr double depth = 4.0;    // m
  SceneFixed box;
  box.size = {length, depth};
  box.position = plane.point - 0.5 * depth * plane.normal;
  box.angle = std::atan2(-plane.normal.x(), plane.normal.y());
  box.material = plane.material;
  return box;
}

/// Fixed boxes of the scene, planes among them.
inline std::vector<SceneFixed> all_fixed(const Scene& scene) {
  std::vector<SceneFixed> boxes = scene.fixed;
  for (const ScenePlane& plane : scene.planes)
    boxes.push_back(box_of_plane(plane));
  return boxes;
}

std::vector<Peer> box2d_peers();
std::vector<Peer> chipmunk_peers();
std::vector<Peer> mujoco_peers();

}  // namespace wuerfel::bench
