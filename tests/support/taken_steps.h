/// A step of time stepping, half by half.
#pragma once

#include "core/time/stepping/landing.h"
#include "core/time/stepping/placement.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {

/// A step of 0.01 s from the start of a scene, with what its halves need.
struct TakenStep {
  explicit TakenStep(const Scene& scene)
      : m(scene),
        work(m.system, {}, step_tolerances(m.system)),
        removal(work),
        resting(work),
        placement(work, removal, resting),
        landing(work, removal, resting),
        stride{h, scales_of(m.system, m.state), m.state, m.state, {}, {}} {
    stride.rods_first.assign(m.system.rods.size(), 0.0);
    stride.rods_second.assign(m.system.rods.size(), 0.0);
    removal.begin(m.state, h);
  }
  /// The impulses of the first half on the bodies of corners, on balance.
  [[nodiscard]] Vec2 first() const {
    Vec2 sum = Vec2::Zero();
    for (const auto& [id, blow] : stride.blows)
      sum += blow.first;
    return sum;
  }
  void find_touching(const State& state) {
    removal.measure(state, touching_share);
    landing.find_touching(stride, book);
  }
  /// Velocities after all that touches where the cubes are has acted.
  State land(State state) {
    find_touching(state);
    stride.before = state;
    landing.strike(state, book);
    return state;
  }

  static constexpr double h = 0.01;
  Mechanism m;
  Workspace work;
  OverlapRemoval removal;
  RestingIslands resting;
  Placement placement;
  Landing landing;
  Stride stride;
  Bookkeeping book;
};

/// In space: a flies at 1 m/s towards b, which is 0.005 m away and has `mass` kg.
///   +---+  +---+
///   | a |->| b |
///   +---+  +---+
inline Scene flying_at(double mass) {
  Scene scene;
  scene.gravity = Vec2::Zero();
  scene.cubes = {cube("a", {0.0, 0.0}), cube("b", {1.005, 0.0})};
  scene.cubes[0].velocity = {1.0, 0.0};
  scene.cubes[1].mass = mass;
  return scene;
}

}  // namespace wuerfel::test
