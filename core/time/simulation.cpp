#include "core/time/simulation.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/model/points.h"
#include "core/time/first_moment.h"
#include "core/time/stepper.h"
#include "core/time/take_snapshot.h"

namespace wuerfel {
namespace {

/// Share of a step within which a time counts as a grid time.
constexpr double same_time = 1e-9;

/// Share of the smaller side below which a cube has not moved.
constexpr double moved_share = 1e-9;

}  // namespace

struct Simulation::Impl {
  Scene scene;
  MotionSettings settings;
  System system;
  Stepper stepper;
  Stepper looker;               ///< for looks between steps: what it remembers is not the motion's
  Moment grid;                  ///< at a whole number of steps
  std::optional<Moment> shown;  ///< between grid times, where somebody asked for it
  Bookkeeping book;
  long whole_steps = 0;
  State start;

  Impl(const Scene& s, const MotionSettings& m)
      : scene(s),
        settings(m),
        system(make_system(s)),
        stepper(system, settings),
        looker(system, settings) {
    grid = first_moment(scene);
    book.audit.energy_start = energy(system, grid.state);
    start = grid.state;
    stepper.arrive(grid, book);
  }

  Moment& current() { return shown ? *shown : grid; }
  [[nodiscard]] const Moment& current() const { return shown ? *shown : grid; }

  void advance_to(double t) {
    shown.reset();
    while (static_cast<double>(whole_steps + 1) * settings.step <= t + same_time * settings.step) {
      stepper.step(grid, settings.step, book);
      grid.t = static_cast<double>(++whole_steps) * settings.step;
      if (!Stepper::at_rest(grid)) note_rods(grid.state);
    }
    const double rest = t - grid.t;
    if (rest <= same_time * settings.step) return;
    // A look between two steps is taken on a copy, so that looking does not change the motion.
    Bookkeeping aside;
    stepper.accelerate(grid, book);
    shown = grid;
    looker.step(*shown, rest, aside);
    shown->t = t;
    book.audit.max_penetration = std::max(book.audit.max_penetration, aside.audit.max_penetration);
    book.cost.qp_solves += aside.cost.qp_solves;
  }

  void note_rods(const State& state) {
    for (std::size_t i = 0; i < state.size(); ++i) {
      const Vec2& size = system.bodies[i].size;
      const double error = rod_error(points_of(state[i], size), size);
      book.audit.max_rod_error = std::max(book.audit.max_rod_error, error);
    }
  }
};

Simulation::Simulation(const Scene& scene, const MotionSettings& settings)
    : impl_(std::make_unique<Impl>(scene, settings)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::advance_to(double t) { impl_->advance_to(t); }

double Simulation::time() const { return impl_->current().t; }

const State& Simulation::states() const { return impl_->current().state; }

const std::vector<Event>& Simulation::events() const { return impl_->book.events; }

Audit Simulation::audit() const {
  Audit audit = impl_->book.audit;
  audit.energy_end = energy(impl_->system, impl_->current().state);
  return audit;
}

const Cost& Simulation::cost() const { return impl_->book.cost; }

Snapshot Simulation::snapshot(const SnapshotRequest& request) const {
  if (request.forces || request.rod_forces)
    impl_->stepper.accelerate(impl_->current(), impl_->book);
  return take_snapshot(impl_->scene, impl_->system, impl_->current(), request);
}

std::vector<std::string> Simulation::moved() const {
  std::vector<std::string> names;
  const State& now = impl_->current().state;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Body& body = impl_->system.bodies[i];
    const double side = body.size.minCoeff();
    const double far = (now[i].position - impl_->start[i].position).norm()
                       + side * std::abs(now[i].angle - impl_->start[i].angle);
    if (far > moved_share * side) names.push_back(body.name);
  }
  return names;
}

bool Simulation::at_rest() const {
  impl_->stepper.accelerate(impl_->current(), impl_->book);
  return Stepper::at_rest(impl_->current());
}

}  // namespace wuerfel
