#include "core/time/events/smooth_phase.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/dynamics/rod_consistency.h"

namespace wuerfel {
namespace {

/// Growth and shrinking of steps [Hairer, Norsett, Wanner 1993, II.4].
constexpr double safety = 0.9;
constexpr double most_growth = 6.0;
constexpr double most_shrinking = 0.2;
/// Units of L / V: the first step, the shortest, the first free fall and the growth of the next.
constexpr double first_length = 0.1;
constexpr double shortest_length = 1e-11;
constexpr double first_fall = 4.0;
constexpr double fall_growth = 4.0;
/// A polynomial is followed beyond its step by no more than this share of it; steps that short are parabolas.
constexpr double beyond_share = 0.01;
/// The angle by which cubes turn at most within one free fall, rad: the search for events looks at
/// every turn.
constexpr double most_turning = 50.0;

/// x^(-1/8), from square roots.
double eighth_root_inverse(double x) { return 1.0 / std::sqrt(std::sqrt(std::sqrt(x))); }

Twist acceleration_of(const std::vector<double>& rate, int cube) {
  const double* a = rate.data() + components * cube + components / 2;
  return {Vec2(a[0], a[1]), a[2]};
}

/// The parabola of free fall within h s.
void set_parabola(const std::vector<double>& y,
                  const std::vector<double>& rate,
                  double h,
                  DenseStep& motion) {
  motion.coefficients.assign(y.size() * DenseStep::terms, 0.0);
  double* c = motion.coefficients.data();
  for (std::size_t i = 0; i < y.size(); ++i, c += DenseStep::terms) {
    const bool position = i % components < components / 2;
    const double half = position ? 0.5 * h * h * rate[i + components / 2] : 0.0;
    c[0] = y[i];
    c[1] = h * rate[i] + half;
    c[2] = -half;
  }
}

}  // namespace

void SmoothPhase::begin(const State& state,
                        const ContactSet& closed,
                        const std::vector<char>& resting,
                        double tolerance) {
  start_ = state;
  equations_.close(closed, resting);
  equations_.project(start_);
  scales_ = scales_of(*system_, start_);
  const double length = tolerance * scales_.length;
  const double speed = tolerance * scales_.speed;
  error_scale_.clear();
  for (std::size_t i = 0; i < state.size(); ++i) {
    for (const double s :
         {length, length, tolerance, speed, speed, tolerance * scales_.speed / scales_.length})
      error_scale_.push_back(s);
  }
  fall_ = first_fall * scales_.time;
  if (proposed_ <= 0.0) proposed_ = first_length * scales_.time;
  pack(start_, y_);
  equations_(y_, rate_);
  equations_.find_loads(loads_);
  push_ = equations_.pushed();
}

/// Evaluates the equations and notes the loads that go with them.
void SmoothPhase::evaluate(const std::vector<double>& y, std::vector<double>& rate) {
  equations_(y, rate);
  equations_.find_loads(seen_);
  if (step_.load_range.size() != seen_.size()) {
    step_.load_range.resize(seen_.size(), {std::numeric_limits<double>::infinity(),
                                           -std::numeric_limits<double>::infinity()});
  }
  const double* load = seen_.data();
  for (BorneRange& range : step_.load_range) {
    range = {std::min(range.low, *load), std::max(range.high, *load)};
    ++load;
  }
}

/// The method's step, and what fixed bodies did in it.
void SmoothPhase::take_step(double length) {
  step_.push = length * Dop853::stage_weights[0] * push_;
  int stage = 0;
  const auto field = [&](const auto& y, auto& rate) {
    evaluate(y, rate);
    const double weight = Dop853::stage_weights[++stage];
    if (weight != 0.0) step_.push += length * weight * equations_.pushed();
  };
  method_.step(field, y_, rate_, length);
}

const SmoothStep& SmoothPhase::step(double most) {
  step_.load_range.clear();
  step_.followed = true;
  step_.push = end_push_ = {};
  step_.flown.clear();
  free() ? fall(most) : integrate(most);
  return step_;
}

void SmoothPhase::fall(double most) {
  double fastest = 0.0;
  for (const BodyState& s : start_)
    fastest = std::max(fastest, std::abs(s.spin));
  const double turning =
      fastest > 0.0 ? most_turning / fastest : std::numeric_limits<double>::infinity();
  const double h = std::min({fall_, turning, most});
  fall_ *= fall_growth;
  step_.length = h;
  set_parabola(y_, rate_, h, step_.motion);
  step_.range.resize(start_.size());
  for (int i = 0; i < static_cast<int>(start_.size()); ++i)
    step_.range[i] = {acceleration_of(rate_, i), acceleration_of(rate_, i)};
  cut(h);
}

/// Takes the step, shortened until its error is small enough.
void SmoothPhase::integrate(double most) {
  double h = std::min(proposed_, most);
  const bool short_cut = h < proposed_;
  double error = 0.0;
  bool rejected = false;
  while (true) {
    step_.load_range.clear();
    take_step(h);
    error = method_.error(error_scale_);
    if (error <= 1.0) break;
    if (h <= shortest_length * scales_.time) {
      step_.followed = false;
      break;
    }
    rejected = true;
    h *= std::isfinite(error) ? std::max(most_shrinking, safety * eighth_root_inverse(error))
                              : most_shrinking;
  }
  const double growth =
      error > 0.0 ? std::min(most_growth, safety * eighth_root_inverse(error)) : most_growth;
  const double next = h * (rejected ? std::min(growth, 1.0) : growth);
  // A step that was cut short says nothing against the length that was proposed before.
  proposed_ = short_cut && !rejected ? std::max(proposed_, next) : next;
  complete(h);
}

/// The end of the step that was just taken, on the contacts, and its polynomial.
void SmoothPhase::complete(double length) {
  const auto field = [this](const auto& y, auto& rate) { evaluate(y, rate); };
  step_.end = start_;
  unpack(method_.next(), step_.end);
  if (equations_.on_fixed()) step_.flown = step_.end;
  equations_.project(step_.end);
  equations_.keep_momenta(start_, length, step_.end);
  pack(step_.end, step_.y);
  evaluate(step_.y, step_.rate);
  step_.followed = step_.followed && !equations_.contradict();
  end_push_ = equations_.pushed();
  step_.loads = seen_;
  step_.elapsed = step_.length = length;
  step_.motion.coefficients.clear();
  if (!watched_) return;
  method_.dense(field, y_, step_.rate, step_.motion);
  note_range();
}

/// Accelerations over all stages and at the end.
void SmoothPhase::note_range() {
  step_.range.resize(start_.size());
  for (int i = 0; i < static_cast<int>(start_.size()); ++i) {
    TwistRange& range = step_.range[i];
    range.low = range.high = acceleration_of(step_.rate, i);
    for (int k = 0; k < Dop853::stages; ++k) {
      const Twist a = acceleration_of(method_.stage(k), i);
      range.low = {range.low.linear.cwiseMin(a.linear), std::min(range.low.angular, a.angular)};
      range.high = {range.high.linear.cwiseMax(a.linear), std::max(range.high.angular, a.angular)};
    }
  }
}

void SmoothPhase::cut(double length) {
  if (!free()) {
    take_step(length);
    complete(length);
    return;
  }
  step_.elapsed = length;
  step_.end = start_;
  look_at(step_.motion, length / step_.length, step_.end);
  pack(step_.end, step_.y);
  equations_(step_.y, step_.rate);
}

/// A state of the end a moment later.
State SmoothPhase::shifted(State state, double time) const {
  for (int i = 0; i < static_cast<int>(state.size()); ++i) {
    BodyState& s = state[i];
    const Twist a = acceleration_of(step_.rate, i);
    s.position += time * s.velocity + 0.5 * time * time * a.linear;
    s.angle += time * s.spin + 0.5 * time * time * a.angular;
    s.velocity += time * a.linear;
    s.spin += time * a.angular;
  }
  return state;
}

void SmoothPhase::shift_end(double time) {
  step_.end = shifted_end(time);
  step_.flown = shifted(std::move(step_.flown), time);
  step_.elapsed += time;
  step_.push += time * end_push_;
  if (step_.elapsed <= (1.0 + beyond_share) * step_.length) return;
  step_.length = step_.elapsed;
  set_parabola(y_, rate_, step_.length, step_.motion);
}

bool SmoothPhase::rods_contradict() const {
  if (system_->rods.size() < 2 || !equations_.redundant()) return false;
  State accelerated = step_.end;
  for (int i = 0; i < static_cast<int>(accelerated.size()); ++i) {
    const Twist a = acceleration_of(step_.rate, i);
    accelerated[i].velocity = a.linear;
    accelerated[i].spin = a.angular;
  }
  return misses_rods(*system_, step_.end, accelerated);
}

void SmoothPhase::go_on() {
  start_ = step_.end;
  y_ = step_.y;
  rate_ = step_.rate;
  loads_ = step_.loads;
  push_ = end_push_;
}

Twist SmoothPhase::acceleration(int cube) const { return acceleration_of(rate_, cube); }

void SmoothPhase::loads_at(const State& state, std::vector<double>& loads) {
  std::vector<double> y;
  std::vector<double> rate;
  pack(state, y);
  equations_(y, rate);
  equations_.find_loads(loads);
}

DenseStep motion_of(const System& system, const MotionPiece& piece) {
  if (!piece.motion.coefficients.empty()) return piece.motion;
  EquationsOfMotion equations(system);
  equations.close({piece.closed, piece.touches}, piece.resting);
  Dop853 method;
  std::vector<double> y;
  std::vector<double> rate;
  pack(piece.start, y);
  equations(y, rate);
  method.step(equations, y, rate, piece.length);
  State end = piece.start;
  unpack(method.next(), end);
  equations.project(end);
  equations.keep_momenta(piece.start, piece.length, end);
  std::vector<double> y_end;
  pack(end, y_end);
  equations(y_end, rate);
  DenseStep motion;
  method.dense(equations, y, rate, motion);
  return motion;
}

}  // namespace wuerfel
