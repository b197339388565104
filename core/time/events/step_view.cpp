#include "core/time/events/step_view.h"

#include "core/model/system.h"

namespace wuerfel {

bool StepView::is_still(int body) const {
  return !system_->is_cube(body) || (!resting_.empty() && resting_[body] != 0);
}

MovingBox StepView::body_of(const State& state, int body) const {
  const Body& b = system_->body(body);
  if (!system_->is_cube(body)) {
    MovingBox fixed;
    fixed.box = b.box;
    if (b.kind == BodyKind::plane) {
      fixed.box.center = b.point;
      fixed.box.axis = -perp(b.normal);
    }
    return fixed;
  }
  const BodyState& s = state[body];
  return {make_box(s.position, s.angle, b.size), s.velocity, s.spin, {}};
}

MovingBox StepView::body_at(int body, double share) const {
  if (!system_->is_cube(body)) return body_of({}, body);
  const std::size_t at = components * body;
  const auto value = [&](std::size_t k) { return step_.motion->component(share, at + k); };
  const auto rate = [&](std::size_t k) {
    return step_.motion->slope(share, at + k) / step_.length;
  };
  return {make_box({value(0), value(1)}, value(2), system_->body(body).size),
          {value(3), value(4)},
          value(5),
          {Vec2(rate(3), rate(4)), rate(5)}};
}

/// Where all bodies are at the ends of a step_.
void StepView::set(const WatchedStep& step) {
  step_ = step;
  begin_.clear();
  end_.clear();
  for (int i = 0; i < system_->count(); ++i) {
    begin_.push_back(body_at(i, 0.0));
    end_.push_back(system_->is_cube(i) ? body_at(i, 1.0) : begin_.back());
  }
}

Look StepView::look_at(const Watch& watch, double share) const {
  const auto at = [&](int body) {
    const auto i = static_cast<std::size_t>(body);
    return share == 0.0 || !system_->is_cube(body) ? begin_[i]
           : share == 1.0                          ? end_[i]
                                                   : body_at(body, share);
  };
  if (watch.kind == Watch::Kind::separation)
    return look_at_separation(at(watch.from), at(watch.on), share);
  Look look;
  look.share = share;
  look.on = at(watch.on);
  look.from = at(watch.from);
  look.reading = read_corner(look.on, watch.corner, look.from, watch.side, watch.kind);
  return look;
}

GapBounds StepView::bounds_of(const Watch& watch,
                              const Look& a,
                              const Look& b,
                              bool swapped) const {
  const auto travel = [&](int body, const MovingBox& begin, const MovingBox& end) {
    const bool still = is_still(body);
    return Travel{&begin, &end, still ? TwistRange{} : (*step_.range)[body], still};
  };
  const Travel on = travel(watch.on, a.on, b.on);
  const Travel from = travel(watch.from, a.from, b.from);
  const double h = step_.length;
  const double part = (b.share - a.share) * h;
  GapBounds bounds = swapped ? bounds_of_gap(from, on, part, h) : bounds_of_gap(on, from, part, h);
  bounds.bend *= h * h;
  bounds.jerk *= h * h * h;
  return bounds;
}

Reading StepView::in_steps(const Reading& r, double shift) const {
  const double h = step_.length;
  return {r.value + shift, r.rate * h, r.bend * h * h};
}

/// Whether the side `pair_side` keeps all corners of the other body outside between two looks.
bool StepView::side_stays_clear(
    const Watch& watch, const Look& a, const Look& b, int pair_side, double shift) const {
  const GapBounds bounds = bounds_of(watch, a, b, pair_side >= 4);
  for (int k = 0; k < 4; ++k) {
    const Reading from = in_steps(read_pair_side(a, pair_side, k), shift);
    const Reading to = in_steps(read_pair_side(b, pair_side, k), shift);
    if (!no_zero_between(from, to, b.share - a.share, bounds)) return false;
  }
  return true;
}

bool StepView::stays_positive(const Watch& watch,
                              const Look& a,
                              const Look& b,
                              double shift) const {
  if (watch.kind == Watch::Kind::separation) {
    return side_stays_clear(watch, a, b, a.pair_side, shift)
           || (b.pair_side != a.pair_side && side_stays_clear(watch, a, b, b.pair_side, shift));
  }
  return no_zero_between(in_steps(a.reading, shift), in_steps(b.reading, shift), b.share - a.share,
                         bounds_of(watch, a, b, false));
}

}  // namespace wuerfel
