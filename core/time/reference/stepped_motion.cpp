#include "core/time/reference/stepped_motion.h"

#include <algorithm>

#include "core/constraints/rod.h"

namespace wuerfel {
namespace {

/// Share of a step within which a time counts as a grid time.
constexpr double same_time = 1e-9;

}  // namespace

SteppedMotion::SteppedMotion(const System& system, const MotionSettings& settings, Moment start)
    : system_(&system),
      settings_(settings),
      stepper_(system, settings),
      looker_(system, settings),
      grid_(std::move(start)) {
  stepper_.arrive(grid_, book_);
}

void SteppedMotion::advance_to(double t) {
  shown_.reset();
  while (static_cast<double>(whole_steps_ + 1) * settings_.step <= t + same_time * settings_.step) {
    beat();
    stepper_.step(grid_, settings_.step, book_);
    grid_.t = static_cast<double>(++whole_steps_) * settings_.step;
    if (!Stepper::at_rest(grid_)) note_rods();
  }
  const double rest = t - grid_.t;
  if (rest <= same_time * settings_.step) return;
  // A look between two steps is taken on a copy, so that looking does not change the motion.
  Bookkeeping aside;
  stepper_.accelerate(grid_, book_);
  shown_ = grid_;
  looker_.step(*shown_, rest, aside);
  shown_->t = t;
  book_.audit.max_penetration = std::max(book_.audit.max_penetration, aside.audit.max_penetration);
  book_.audit.max_overlap = std::max(book_.audit.max_overlap, aside.audit.max_overlap);
  book_.cost.qp_solves += aside.cost.qp_solves;
}

const Moment& SteppedMotion::now_with_forces() {
  Moment& moment = shown_ ? *shown_ : grid_;
  stepper_.accelerate(moment, book_);
  return moment;
}

void SteppedMotion::note_rods() {
  for (std::size_t i = 0; i < grid_.state.size(); ++i) {
    const Vec2& size = system_->bodies[i].size;
    const double error = largest_rod_error(points_of(grid_.state[i], size), size);
    book_.audit.max_rod_error = std::max(book_.audit.max_rod_error, error);
  }
}

}  // namespace wuerfel
