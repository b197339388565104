/// Simulation: a scene in motion. The façade that programs use: make one, advance it, look at it.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/state.h"
#include "core/scene/scene.h"
#include "core/settings.h"
#include "core/snapshot.h"

namespace wuerfel {

enum class EventKind { impact, touch, release, slide_off, stick, slip, rest };
std::string_view to_string(EventKind kind);

/// Something that happened at one instant.
struct Event {
  double t = 0.0;  ///< s
  EventKind kind = EventKind::impact;
  std::string on;    ///< body the impulse acts on
  std::string from;  ///< body it comes from
  Vec2 point = Vec2::Zero();  ///< m
  double impulse = 0.0;       ///< N s
};

/// Invariants kept book of in every run.
struct Audit {
  double max_penetration = 0.0;   ///< m, deepest overlap of any pair at any step end
  double max_rod_error = 0.0;     ///< largest relative change of a rod's length
  double max_kkt_residual = 0.0;  ///< worst optimality residual of any program that was used
  int missed_solves = 0;          ///< programs whose residual missed the tolerance
  double energy_start = 0.0;      ///< J
  double energy_end = 0.0;        ///< J
  double impact_loss = 0.0;       ///< J, taken by impacts
  double friction_loss = 0.0;     ///< J
  [[nodiscard]] double drift() const { return energy_end + impact_loss + friction_loss - energy_start; }
};

struct Cost {
  long steps = 0;
  long qp_solves = 0;
  long qp_skipped = 0;  ///< programs answered without a solver: free flight, certified rest, unchanged islands
};

/// What a snapshot should contain beyond bodies; each costs work only where it is asked for.
struct SnapshotRequest {
  bool forces = false;
  bool rods = false;
  bool rod_forces = false;
  bool points = false;
  bool contacts = false;
};

class Simulation {
 public:
  /// Throws SceneError where bodies overlap. An impact at the start is applied at once.
  Simulation(const Scene& scene, const MotionSettings& settings);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Moves on to time `t` exactly (t >= time()); the state is that just after an event that falls on `t`.
  void advance_to(double t);

  [[nodiscard]] double time() const;
  /// One per cube, in the order of Scene::cubes.
  [[nodiscard]] const State& states() const;
  [[nodiscard]] const std::vector<Event>& events() const;
  [[nodiscard]] Audit audit() const;
  [[nodiscard]] const Cost& cost() const;
  [[nodiscard]] Snapshot snapshot(const SnapshotRequest& request) const;
  /// Names of cubes that have moved by more than rounding since the start.
  [[nodiscard]] std::vector<std::string> moved() const;
  [[nodiscard]] bool at_rest() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace wuerfel
