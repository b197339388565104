#include "core/time/simulation.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/forces_at.h"
#include "core/time/island_motion.h"
#include "core/time/policy.h"
#include "core/time/reference/fixed_step_motion.h"
#include "core/time/shown_causes.h"
#include "core/time/shown_ranges.h"
#include "core/time/start_state.h"
#include "core/time/take_snapshot.h"

namespace wuerfel {
namespace {

bool in_groups(const MotionSettings& settings) {
  return policy_of(settings).method == MotionPolicy::Method::groups;
}

/// Motions in steps of one length know neither friction nor restitution: their forces have none.
System system_of(const Scene& scene, const MotionSettings& settings) {
  System system = make_system(scene);
  if (!in_groups(settings)) system.rubs = system.bounces = false;
  return system;
}

/// `more`: where the motion is taken up again, a restart point.
template <typename... More>
std::unique_ptr<Motion> make_motion(const System& system,
                                    const MotionSettings& settings,
                                    const State& start,
                                    const More&... more) {
  if (in_groups(settings)) return std::make_unique<IslandMotion>(system, settings, start, more...);
  return std::make_unique<FixedStepMotion>(system, settings, start, more...);
}

void add(const LookCost& more, LookCost& cost) {
  cost.qp_solves += more.qp_solves;
  cost.force_choices += more.force_choices;
  cost.skipped_free += more.skipped_free;
  cost.unchanged += more.unchanged;
}

}  // namespace

struct Simulation::Impl {
  Scene scene;
  System system;
  State start;
  double energy_start = 0.0;
  MotionSettings settings;
  std::unique_ptr<Motion> motion;
  ForceFinder finder;
  RangeFinder range_finder;
  LookCost look_cost;

  template <typename... More>
  Impl(const Scene& s, const MotionSettings& chosen, const More&... more)
      : scene(s),
        system(system_of(s, chosen)),
        start(start_state(s)),
        energy_start(energy(system, start)),
        settings(chosen),
        motion(make_motion(system, settings, start, more...)),
        finder(system, settings) {
    require_consistent_rods(system, motion->state(),
                            [this] { return look(Detail::accelerations).accelerations; });
  }

  /// What touches and presses where the motion is. The motion and its books do not notice.
  const InstantForces& look(Detail detail) {
    return look(motion->state(), motion->loaded(), detail);
  }
  const InstantForces& look(const State& state, const std::vector<Contact>& loaded, Detail detail) {
    const InstantForces& found = finder.at(state, detail, loaded);
    add(found.cost, look_cost);
    return found;
  }

  Snapshot snapshot(double t,
                    const State& state,
                    const std::vector<Contact>& loaded,
                    const SnapshotRequest& request) {
    const InstantForces& found = look(state, loaded, detail_of(request));
    std::vector<ForceRanges> ranges;
    if (request.ranges) ranges = range_finder.at(system, state, found);
    Snapshot snapshot = take_snapshot(scene, system, state, found, ranges, request);
    snapshot.time = t;
    snapshot.energy_start = energy_start;
    if (request.causes || request.mechanism)
      add_causes(held_still(system, settings, state, loaded), request, snapshot);
    return snapshot;
  }
};

Simulation::Simulation(const Scene& scene, const MotionSettings& settings)
    : impl_(std::make_unique<Impl>(scene, settings)) {}
Simulation::Simulation(const Scene& scene,
                       const MotionSettings& settings,
                       std::string_view restart_point)
    : impl_(std::make_unique<Impl>(
        scene, settings, restart_point_of(restart_point, scene.cubes.size()))) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::advance_to(double t) { impl_->motion->advance_to(t); }

void Simulation::set_pulse(std::function<void()> pulse) {
  impl_->motion->set_pulse(std::move(pulse));
}

void Simulation::set_restart_listener(std::function<void(std::string restart_point)> listener) {
  impl_->motion->set_restart_listener(
      [listener = std::move(listener)](const RestartPoint& point) { listener(to_bytes(point)); });
}

double Simulation::time() const { return impl_->motion->time(); }

double Simulation::reached() const { return impl_->motion->reached(); }

const State& Simulation::states() const { return impl_->motion->state(); }

const std::vector<Event>& Simulation::events() const { return impl_->motion->book().events; }

Audit Simulation::audit() const {
  Audit audit = impl_->motion->book().audit;
  audit.energy_start = impl_->energy_start;
  audit.energy_end = energy(impl_->system, impl_->motion->state());
  return audit;
}

const std::vector<Breach>& Simulation::breaches() const { return impl_->motion->book().breaches; }

std::uint64_t Simulation::state_hash() const {
  StateHash hash = impl_->motion->hash();
  hash.add(time(), states());
  return hash.value();
}

const Cost& Simulation::cost() const { return impl_->motion->book().cost; }

const LookCost& Simulation::look_cost() const { return impl_->look_cost; }

Snapshot Simulation::snapshot(const SnapshotRequest& request) const {
  return impl_->snapshot(time(), impl_->motion->state(), impl_->motion->loaded(), request);
}

Moment Simulation::moment() const {
  return {time(), impl_->motion->state(), to_bytes(impl_->motion->loaded())};
}

Snapshot Simulation::snapshot(const Moment& moment, const SnapshotRequest& request) const {
  return impl_->snapshot(moment.t, moment.state, contacts_of(moment.loaded, impl_->system.count()),
                         request);
}

std::vector<std::string> Simulation::moved() const {
  std::vector<std::string> names;
  const State& now = impl_->motion->state();
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Body& body = impl_->system.bodies[i];
    const double side = body.smaller_side();
    const double far = (now[i].position - impl_->start[i].position).norm()
                       + side * std::abs(now[i].angle - impl_->start[i].angle);
    if (far > touching_tolerance * side) names.push_back(body.name);
  }
  return names;
}

bool Simulation::at_rest() const {
  const bool still = std::ranges::all_of(states(), [](const BodyState& s) { return is_still(s); });
  return still && impl_->look(Detail::accelerations).at_rest;
}

}  // namespace wuerfel
