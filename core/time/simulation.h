/// Simulation: a scene in motion. The façade that programs use: make one, advance it, look at it.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/dynamics/look_cost.h"
#include "core/model/state.h"
#include "core/scene/scene.h"
#include "core/settings.h"
#include "core/snapshot.h"
#include "core/time/bookkeeping.h"

namespace wuerfel {

class Simulation {
 public:
  /// Throws SceneError where bodies overlap. An impact at the start is applied at once.
  Simulation(const Scene& scene, const MotionSettings& settings);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Moves on to time `t` exactly (t >= time()); the state is that just after an event that falls
  /// on `t`.
  void advance_to(double t);
  /// `pulse` is called again and again while `advance_to` works, so that somebody who waits can be
  /// told, or stop it: what it throws leaves `advance_to`, and the simulation can only be destroyed
  /// then.
  void set_pulse(std::function<void()> pulse);

  [[nodiscard]] double time() const;
  /// One per cube, in the order of Scene::cubes.
  [[nodiscard]] const State& states() const;
  [[nodiscard]] const std::vector<Event>& events() const;
  [[nodiscard]] Audit audit() const;
  /// Of the motion, whoever looked at it how often.
  [[nodiscard]] const Cost& cost() const;
  /// Of the looks: what `snapshot` and `at_rest` took.
  [[nodiscard]] const LookCost& look_cost() const;
  [[nodiscard]] Snapshot snapshot(const SnapshotRequest& request) const;
  /// Names of cubes that have moved by more than rounding since the start.
  [[nodiscard]] std::vector<std::string> moved() const;
  /// Whether every cube stands still and would go on to: certified, as in `check`.
  [[nodiscard]] bool at_rest() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace wuerfel
