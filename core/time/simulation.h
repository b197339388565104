/// Simulation: a scene in motion. The façade that programs use: make one, advance it, look at it.
#pragma once

#include <cstdint>
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

/// What can be seen at an instant.
struct Moment {
  double t = 0.0;  ///< s
  State state;
  std::string loaded;  ///< contacts that carried load in a step in which t lies, as bytes
};

class Simulation {
 public:
  /// Throws SceneError where bodies overlap. An impact at the start is applied at once.
  Simulation(const Scene& scene, const MotionSettings& settings);
  /// The same taken up again at a restart point: goes on to the same bits.
  /// Throws RestartError (core/time/restart_point.h) where the bytes are none.
  Simulation(const Scene& scene, const MotionSettings& settings, std::string_view restart_point);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Moves on to time `t` exactly (t >= time()); the state is that just after an event that falls
  /// on `t`.
  void advance_to(double t);
  /// `pulse` is called again and again while `advance_to` works, so that somebody who waits can be
  /// told, or stop it: what it throws leaves `advance_to`, and the simulation can only be destroyed
  /// then.
  void set_pulse(std::function<void()> pulse);

  /// At instants that depend on the motion alone it forgets what solvers remember and goes by what
  /// stands in a restart point. `listener` is told of each; all looks up to now lie before it.
  void set_restart_listener(std::function<void(std::string restart_point)> listener);

  [[nodiscard]] double time() const;
  /// How far the motion has been computed: what somebody who waits for `advance_to` can be told.
  [[nodiscard]] double reached() const;
  /// One per cube, in the order of Scene::cubes.
  [[nodiscard]] const State& states() const;
  [[nodiscard]] const std::vector<Event>& events() const;
  [[nodiscard]] Audit audit() const;
  /// Promises that were broken, in no order: programs, events, friction and overlap.
  [[nodiscard]] const std::vector<Breach>& breaches() const;
  /// A number for the states up to time(): equal where every bit of them is, however often and at what
  /// was looked.
  [[nodiscard]] std::uint64_t state_hash() const;
  /// Of the motion, whoever looked at it how often.
  [[nodiscard]] const Cost& cost() const;
  /// Of the looks: what `snapshot` and `at_rest` took.
  [[nodiscard]] const LookCost& look_cost() const;
  [[nodiscard]] Snapshot snapshot(const SnapshotRequest& request) const;
  /// What `snapshot` sees now, to be seen again whenever that is.
  [[nodiscard]] Moment moment() const;
  [[nodiscard]] Snapshot snapshot(const Moment& moment, const SnapshotRequest& request) const;
  /// Names of cubes that have moved by more than rounding since the start.
  [[nodiscard]] std::vector<std::string> moved() const;
  /// Whether every cube stands still and would go on to: certified, as in `check`.
  [[nodiscard]] bool at_rest() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace wuerfel
