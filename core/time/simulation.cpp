#include "core/time/simulation.h"

#include <algorithm>
#include <cmath>

#include "core/time/first_moment.h"
#include "core/time/island_motion.h"
#include "core/time/reference/stepped_motion.h"
#include "core/time/take_snapshot.h"

namespace wuerfel {
namespace {

/// Share of the smaller side below which a cube has not moved.
constexpr double moved_share = 1e-9;

std::unique_ptr<Motion> make_motion(const System& system,
                                    const MotionSettings& settings,
                                    Moment start) {
  switch (settings.integrator) {
    case Integrator::euler:
    case Integrator::symplectic:
    case Integrator::moreau:
      return std::make_unique<SteppedMotion>(system, settings, std::move(start));
    case Integrator::automatic:
    case Integrator::event:
    case Integrator::rattle:
      break;
  }
  return std::make_unique<IslandMotion>(system, settings, std::move(start));
}

}  // namespace

struct Simulation::Impl {
  Scene scene;
  System system;
  std::unique_ptr<Motion> motion;
  State start;
  double energy_start = 0.0;

  Impl(const Scene& s, const MotionSettings& settings) : scene(s), system(make_system(s)) {
    Moment first = first_moment(scene);
    start = first.state;
    energy_start = energy(system, start);
    motion = make_motion(system, settings, std::move(first));
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

const State& Simulation::states() const { return impl_->motion->now().state; }

const std::vector<Event>& Simulation::events() const { return impl_->motion->book().events; }

Audit Simulation::audit() const {
  Audit audit = impl_->motion->book().audit;
  audit.energy_start = impl_->energy_start;
  audit.energy_end = energy(impl_->system, impl_->motion->now().state);
  return audit;
}

const Cost& Simulation::cost() const { return impl_->motion->book().cost; }

Snapshot Simulation::snapshot(const SnapshotRequest& request) const {
  const bool forces = request.forces || request.rod_forces;
  return take_snapshot(
      impl_->scene, impl_->system,
      forces ? impl_->motion->now_with_forces() : impl_->motion->now_with_contacts(), request);
}

std::vector<std::string> Simulation::moved() const {
  std::vector<std::string> names;
  const State& now = impl_->motion->now().state;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Body& body = impl_->system.bodies[i];
    const double side = body.size.minCoeff();
    const double far = (now[i].position - impl_->start[i].position).norm()
                       + side * std::abs(now[i].angle - impl_->start[i].angle);
    if (far > moved_share * side) names.push_back(body.name);
  }
  return names;
}

bool Simulation::at_rest() const { return Stepper::at_rest(impl_->motion->now_with_forces()); }

}  // namespace wuerfel
