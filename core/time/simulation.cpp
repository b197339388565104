#include "core/time/simulation.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/forces_at.h"
#include "core/time/island_motion.h"
#include "core/time/policy.h"
#include "core/time/reference/fixed_step_motion.h"
#include "core/time/start_state.h"
#include "core/time/take_snapshot.h"

namespace wuerfel {
namespace {

/// Share of the smaller side below which a cube has not moved.
constexpr double moved_share = 1e-9;

std::unique_ptr<Motion> make_motion(const System& system,
                                    const MotionSettings& settings,
                                    const State& start) {
  if (policy_of(settings).method == MotionPolicy::Method::groups)
    return std::make_unique<IslandMotion>(system, settings, start);
  return std::make_unique<FixedStepMotion>(system, settings, start);
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
  std::unique_ptr<Motion> motion;
  ForceFinder finder;
  LookCost look_cost;

  Impl(const Scene& s, const MotionSettings& settings)
      : scene(s),
        system(make_system(s)),
        start(start_state(s)),
        energy_start(energy(system, start)),
        motion(make_motion(system, settings, start)),
        finder(system, settings) {
    require_consistent_rods(system, motion->state());
  }

  /// What touches and presses where the motion is. The motion and its books do not notice.
  const InstantForces& look(Detail detail) {
    const InstantForces& found = finder.at(motion->state(), detail, motion->loaded());
    add(found.cost, look_cost);
    return found;
  }
};

Simulation::Simulation(const Scene& scene, const MotionSettings& settings)
    : impl_(std::make_unique<Impl>(scene, settings)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::advance_to(double t) { impl_->motion->advance_to(t); }

void Simulation::set_pulse(std::function<void()> pulse) {
  impl_->motion->set_pulse(std::move(pulse));
}

double Simulation::time() const { return impl_->motion->time(); }

const State& Simulation::states() const { return impl_->motion->state(); }

const std::vector<Event>& Simulation::events() const { return impl_->motion->book().events; }

Audit Simulation::audit() const {
  Audit audit = impl_->motion->book().audit;
  audit.energy_start = impl_->energy_start;
  audit.energy_end = energy(impl_->system, impl_->motion->state());
  return audit;
}

const Cost& Simulation::cost() const { return impl_->motion->book().cost; }

const LookCost& Simulation::look_cost() const { return impl_->look_cost; }

Snapshot Simulation::snapshot(const SnapshotRequest& request) const {
  Snapshot snapshot = take_snapshot(impl_->scene, impl_->system, impl_->motion->state(),
                                    impl_->look(detail_of(request)), request);
  snapshot.time = time();
  snapshot.energy_start = impl_->energy_start;
  return snapshot;
}

std::vector<std::string> Simulation::moved() const {
  std::vector<std::string> names;
  const State& now = impl_->motion->state();
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Body& body = impl_->system.bodies[i];
    const double side = body.smaller_side();
    const double far = (now[i].position - impl_->start[i].position).norm()
                       + side * std::abs(now[i].angle - impl_->start[i].angle);
    if (far > moved_share * side) names.push_back(body.name);
  }
  return names;
}

bool Simulation::at_rest() const { return impl_->look(Detail::accelerations).at_rest; }

}  // namespace wuerfel
