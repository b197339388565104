#include "core/time/reference/fixed_step_motion.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/constraints/rod.h"
#include "core/dynamics/rod_rows.h"
#include "core/model/points.h"
#include "core/qp/qp_solver.h"
#include "core/time/promises.h"
#include "core/time/reference/active_restrictions.h"
#include "core/time/reference/algorithm_1.h"
#include "core/time/reference/moreau.h"
#include "core/time/rod_events.h"

namespace wuerfel {
namespace {

/// What Moreau's steps may gain, as a share of what was in motion and was lost.
constexpr double gained_share = 0.1;
/// What moves with more than so many times the energy of the start moves no more by any law.
constexpr double diverged_times = 1e12;
/// Share of a step within which a time counts as a grid time.
constexpr double same_grid_time = 1e-9;

RestartPoint beginning(const System& system, const State& start) {
  RestartPoint point;
  point.state = start;
  point.momentum = momentum_scale(system, start, scales_of(system, start).speed);
  return point;
}

}  // namespace

FixedStepMotion::FixedStepMotion(const System& system,
                                 const MotionSettings& settings,
                                 const State& start)
    : FixedStepMotion(system, settings, start, beginning(system, start)) {}

FixedStepMotion::FixedStepMotion(const System& system,
                                 const MotionSettings& settings,
                                 const State& start,
                                 const RestartPoint& point)
    : system_(&system),
      settings_(settings),
      work_(system, settings),
      scales_(scales_of(system, start)),
      energy_start_(energy(system, start)),
      in_motion_(energy_in_motion(system, start, scales_)),
      momentum_(point.momentum),
      hash_(point.hash),
      book_(point.book),
      whole_steps_(point.steps),
      time_(point.t) {
  begin(point.state);
}

/// The first grid point, of a method that remembers nothing.
void FixedStepMotion::begin(const State& state) {
  grid_ = {};
  grid_.t = static_cast<double>(whole_steps_) * settings_.step;
  grid_.state = state;
  find_restrictions(grid_, work_, book_);
}

void FixedStepMotion::restart() {
  stepped_ = 0;
  if (listener())
    listener()({grid_.t, grid_.state, book_, hash_, momentum_, 0.0, {}, {}, whole_steps_});
  work_ = Workspace(*system_, settings_);
  begin(State(grid_.state));
}

/// One step of the chosen method.
void FixedStepMotion::take(GridPoint& point, double dt, Workspace& work, Bookkeeping& book) const {
  if (policy_.method == MotionPolicy::Method::moreau) return step_by_moreau(point, dt, work, book);
  step_by_algorithm_1(point, dt, policy_.as_printed, work, book);
}

void FixedStepMotion::advance_to(double t) {
  between_.clear();
  while (static_cast<double>(whole_steps_ + 1) * settings_.step
         <= t + same_grid_time * settings_.step) {
    beat();
    step();
    grid_.t = static_cast<double>(++whole_steps_) * settings_.step;
    if (stepped_ >= work_between_restarts) restart();
  }
  time_ = t;
}

void FixedStepMotion::step() {
  ++book_.cost.steps;
  // What rests altogether stays: not even its contacts are looked for.
  if (grid_.at_rest()) {
    book_.cost.skipped_rest += static_cast<long>(grid_.islands.size());
    return;
  }
  stepped_ += system_->cubes;
  if (!(kinetic_energy(*system_, grid_.state) <= diverged_times * in_motion_)) fail();
  const State before = grid_.state;
  grid_.push = {};
  take(grid_, settings_.step, work_, book_);
  book_.unexplained += unexplained(*system_, before, grid_.state, settings_.step, grid_.push);
  momentum_.include(momentum_scale(*system_, grid_.state, scales_.speed));
  note_unexplained(momentum_, book_);
  // Euler's steps as printed move places by the old velocities, which turns momenta without a bound.
  if (!policy_.as_printed) {
    book_.audit.momentum_budget = promised_momentum_of_first_order;
    const double t = grid_.t + settings_.step;
    book_.audit.settled_budget = promised_settled_of_first_order * (1.0 + t / scales_.time);
  }
  hash_.add(grid_.t, grid_.state);
  if (!grid_.at_rest()) note_rods();
  if (policy_.method == MotionPolicy::Method::moreau) note_energy();
}

void FixedStepMotion::fail() const {
  throw SolverError(
      fmt::format("the motion runs away from all bounds at {:.4g} s: steps of {:.4g} s are too "
                  "long for --integrator {}; try a shorter "
                  "--step, or another integrator",
                  grid_.t, settings_.step, to_string(settings_.integrator)));
}

/// Moreau's steps lose energy by themselves and gain none but by their order: what gains more is wrong.
void FixedStepMotion::note_energy() {
  const double gained = energy(*system_, grid_.state) + book_.audit.impact_loss - energy_start_;
  const double budget = gained_share * (in_motion_ + book_.audit.impact_loss);
  if (gained <= budget || book_.audit.drift_budget > 0.0) return;
  book_.audit.drift_budget = budget;
  book_.breaches.push_back({Promise::energy, grid_.t, {}});
}

const State& FixedStepMotion::state() {
  const double rest = time_ - grid_.t;
  if (rest <= same_grid_time * settings_.step || grid_.at_rest()) return grid_.state;
  if (between_.empty()) {
    // A shorter step aside, where nothing is remembered: looking does not change the motion.
    GridPoint point = grid_;
    Workspace work(*system_, settings_);
    Bookkeeping aside;
    take(point, rest, work, aside);
    between_ = std::move(point.state);
  }
  return between_;
}

void FixedStepMotion::note_rods() {
  for (std::size_t i = 0; i < grid_.state.size(); ++i) {
    if (system_->bodies[i].kind == BodyKind::point) continue;
    const Vec2& size = system_->bodies[i].size;
    const double error = largest_rod_error(points_of(grid_.state[i], size), size);
    book_.audit.max_rod_error = std::max(book_.audit.max_rod_error, error);
  }
  const bool kept = book_.audit.max_rod_error <= promised_rod_error;
  book_.audit.max_rod_error =
      std::max(book_.audit.max_rod_error, largest_rod_error(*system_, grid_.state));
  if (kept && book_.audit.max_rod_error > promised_rod_error)
    book_.breaches.push_back({Promise::rods, grid_.t, lost_rods(*system_, grid_.state)});
}

}  // namespace wuerfel
