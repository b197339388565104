/// Smooth phases that tests begin: of small mechanisms after their first instant.
#pragma once

#include <cmath>

#include "core/time/events/instant.h"
#include "core/time/events/smooth_phase.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {

/// A phase that begins with what a mechanism's first instant leaves closed.
struct Begun {
  explicit Begun(const Scene& scene)
      : m(scene),
        work(m.system, {}),
        now(happen(m.state, 0.0, {}, {}, work)),
        phase(m.system, true) {
    phase.begin(now.state, now.modes.closed, now.modes.resting, 1e-12);
  }
  Mechanism m;
  Workspace work;
  Instant now;
  SmoothPhase phase;
};

/// A cube that is thrown up at 2 m/s, 3 m above the floor.
inline Scene thrown() {
  Scene scene = on_floor({cube("a", {0.0, 3.5})});
  scene.cubes[0].velocity = {1.0, 2.0};
  return scene;
}

/// A block that slides down a plane of 3 in 4.
inline Scene slide() {
  Scene scene;
  const Vec2 normal(0.6, 0.8);
  scene.planes.push_back({"slope", Vec2::Zero(), normal, {}});
  scene.cubes = {sized_cube("a", 0.5 * normal, Vec2::Ones(), std::atan2(-0.6, 0.8))};
  return scene;
}

}  // namespace wuerfel::test
