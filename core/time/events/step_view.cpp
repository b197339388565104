#include "core/time/events/step_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wuerfel {
namespace {

/// Separations below this share of the smallest side may count as zero.
constexpr double separated_share = 1e-12;

}  // namespace

MovingBox body_of(const System& system, const State& state, int body) {
  const Body& b = system.body(body);
  if (!system.is_cube(body)) return fixed_body(b);
  const BodyState& s = state[body];
  return {make_box(s.position, s.angle, b.size), s.velocity, s.spin, {}};
}

Jet value_at(const System& system, const State& state, const EventFunction& f) {
  const MovingPair pair{body_of(system, state, f.on), body_of(system, state, f.from)};
  if (f.kind == EventFunction::Kind::separation) return separation_by(pair, separating_side(pair));
  return corner_at_side(pair.on, f.corner, pair.from, f.side, f.kind);
}

void StepView::begin(const std::vector<char>& resting, double rounding) {
  resting_ = resting;
  // Never near what counts as touching: what is no contact would meet for ever.
  double length = std::numeric_limits<double>::max();
  for (int i = 0; i < system_->cubes; ++i)
    length = std::min(length, system_->body(i).smaller_side());
  separated_ = std::min(2.0 * rounding, separated_share * length);
}

bool StepView::is_still(int body) const {
  return !system_->is_cube(body) || (!resting_.empty() && resting_[body] != 0);
}

MovingBox StepView::body_at(int body, double share) const {
  const Body& b = system_->body(body);
  if (!system_->is_cube(body)) return fixed_body(b);
  const std::size_t at = components * body;
  const auto value = [&](int k) { return motion_->component(share, at + k); };
  const auto rate = [&](int k) { return motion_->slope(share, at + k) / length_; };
  return {make_box({value(0), value(1)}, value(2), b.size),
          {value(3), value(4)},
          value(5),
          {Vec2(rate(3), rate(4)), rate(5)}};
}

void StepView::set(const DenseStep& motion, double length, const std::vector<TwistRange>& range) {
  motion_ = &motion;
  length_ = length;
  range_ = &range;
  begin_.clear();
  end_.clear();
  for (int i = 0; i < system_->count(); ++i) {
    begin_.push_back(body_at(i, 0.0));
    end_.push_back(system_->is_cube(i) ? body_at(i, 1.0) : begin_.back());
  }
}

Vec2 StepView::center_at(int body, double share) const {
  return share == 0.0 ? begin_[body].box.center : end_[body].box.center;
}

// A path leaves its chord by no more than a h^2 / 8.
Vec2 StepView::bulge(int cube) const {
  const TwistRange& range = (*range_)[cube];
  const Vec2 a = range.low.linear.cwiseAbs().cwiseMax(range.high.linear.cwiseAbs());
  return (acceleration_reserve / 8.0) * length_ * length_ * a;
}

Jet StepView::in_steps(const Jet& jet, double shift) const {
  return {jet.value + shift, jet.first * length_, jet.second * length_ * length_};
}

StepView::Look StepView::look_at(const EventFunction& f, double share) const {
  const auto at = [&](int body) {
    return share == 0.0 || !system_->is_cube(body) ? begin_[body]
           : share == 1.0                          ? end_[body]
                                                   : body_at(body, share);
  };
  Look look;
  look.share = share;
  look.pair = {at(f.on), at(f.from)};
  if (f.kind == EventFunction::Kind::separation) {
    look.side = separating_side(look.pair);
    look.jet = in_steps(separation_by(look.pair, look.side), -separated_);
  } else {
    look.jet =
        in_steps(corner_at_side(look.pair.on, f.corner, look.pair.from, f.side, f.kind), 0.0);
  }
  return look;
}

DerivativeBounds StepView::bounds(const EventFunction& f,
                                  const Look& a,
                                  const Look& b,
                                  bool side_of_on) const {
  const auto travel = [&](int body, const MovingBox& begin, const MovingBox& end) {
    const bool still = is_still(body);
    return Travel{&begin, &end, still ? TwistRange{} : (*range_)[body], still};
  };
  const Travel on = travel(f.on, a.pair.on, b.pair.on);
  const Travel from = travel(f.from, a.pair.from, b.pair.from);
  const double h = length_;
  const double part = (b.share - a.share) * h;
  DerivativeBounds bounds =
      side_of_on ? bounds_of_corners(from, on, part, h) : bounds_of_corners(on, from, part, h);
  bounds.second *= h * h;
  bounds.third *= h * h * h;
  return bounds;
}

double StepView::second_bound(const EventFunction& f, const Look& a, const Look& b) const {
  return bounds(f, a, b, a.side.of_on).second;
}

/// Whether a side keeps all corners of the other body outside between two looks.
bool StepView::side_stays_clear(const EventFunction& f,
                                const Look& a,
                                const Look& b,
                                const PairSide& side,
                                double shift) const {
  const DerivativeBounds within = bounds(f, a, b, side.of_on);
  for (int k = 0; k < Box::corners; ++k) {
    const Jet from = in_steps(gap_of_corner(a.pair, side, k), shift - separated_);
    const Jet to = in_steps(gap_of_corner(b.pair, side, k), shift - separated_);
    if (!no_zero_between(from, to, b.share - a.share, within)) return false;
  }
  return true;
}

bool StepView::positive_between(const EventFunction& f,
                                const Look& a,
                                const Look& b,
                                double shift) const {
  if (f.kind == EventFunction::Kind::separation) {
    return side_stays_clear(f, a, b, a.side, shift)
           || (b.side != a.side && side_stays_clear(f, a, b, b.side, shift));
  }
  Jet from = a.jet;
  Jet to = b.jet;
  from.value += shift;
  to.value += shift;
  return no_zero_between(from, to, b.share - a.share, bounds(f, a, b, false));
}

}  // namespace wuerfel
