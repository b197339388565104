#include "core/time/events/geometric_events.h"

#include <algorithm>

namespace wuerfel {
namespace {

/// Bounds of cubes are blown up by this share, against rounding.
constexpr double bounds_rounding = 1e-9;

using Kind = EventFunction::Kind;

}  // namespace

GeometricEvents::GeometricEvents(const System& system) : system_(&system), view_(system) {}

double GeometricEvents::zero(const EventFunction& f) const {
  return std::max(event_touching * contact_scale(*system_, f.on, f.from), rounding_);
}

void GeometricEvents::begin(const State& state,
                            const ContactSet& closed,
                            const std::vector<char>& resting) {
  rounding_ = gap_rounding(state);
  view_.begin(resting, rounding_);
  functions_.clear();
  watch_closed(closed);
  watch_planes(closed);
  for (EventFunction& f : functions_)
    f.arming = Arming::at_start(value_at(*system_, state, f).value, zero(f));
  watch_touching(state);
}

/// Of a corner on a side: its neighbours may come down on the side, and it may come to an end. Of
/// flush sides: the overlap ends where a corner of the shorter one has come to the end of the
/// longer one. The sides run in opposite senses, so that the first of two corners comes first along
/// the side.
void GeometricEvents::watch_closed(const ContactSet& closed) {
  closed_pairs_.clear();
  for (const Touch& touch : closed.touches) {
    if (touch.kind == Touch::Kind::on_plane) continue;
    closed_pairs_.push_back(touch.pair());
    const auto add = [&](Kind kind, int corner) {
      functions_.push_back({kind, touch.on, touch.from, corner, touch.side});
    };
    const int corner = closed.contacts[touch.first].corner;
    if (touch.kind == Touch::Kind::flush) {
      add(Kind::to_end, corner);
      add(Kind::to_start, next_corner(corner));
      continue;
    }
    if (system_->body(touch.on).kind != BodyKind::point) {
      add(Kind::gap, next_corner(corner));
      add(Kind::gap, previous_corner(corner));
    }
    add(Kind::to_start, corner);
    add(Kind::to_end, corner);
  }
  std::ranges::sort(closed_pairs_);
}

void GeometricEvents::watch_planes(const ContactSet& closed) {
  std::vector<ContactId> on_planes;
  for (const Contact& c : closed.contacts) {
    if (system_->body(c.from).kind == BodyKind::plane) on_planes.push_back(c.id());
  }
  std::ranges::sort(on_planes);
  for (int p = box_count(*system_); p < system_->count(); ++p) {
    for (int i = 0; i < system_->cubes; ++i) {
      if (view_.is_still(i)) continue;
      for (int k = 0; k < system_->body(i).corner_count(); ++k) {
        if (!std::ranges::binary_search(on_planes, contact_id(i, p, k, 0)))
          functions_.push_back({Kind::gap, i, p, k, plane_side});
      }
    }
  }
}

/// Pairs that touch without being closed: they open, and may come back.
void GeometricEvents::watch_touching(const State& state) {
  touching_.clear();
  std::vector<Box> boxes;
  pose_boxes(*system_, state, boxes);
  const auto bounds_of = [&](int i) {
    return posed_bounds(boxes[i], 4.0 * event_touching * boxes[i].smaller_side());
  };
  for (const auto& [i, j] : neighbours_.find(*system_, bounds_of)) {
    if (view_.is_still(i) && view_.is_still(j)) continue;
    if (std::ranges::binary_search(closed_pairs_, IndexPair(i, j))) continue;
    EventFunction f{Kind::separation, i, j};
    f.arming = Arming::at_start(separation(boxes[i], boxes[j]), zero(f));
    if (f.arming.shift > 0.0) touching_.push_back(f);
  }
}

void GeometricEvents::find_candidates() {
  candidates_.clear();
  const auto bounds_of = [&](int i) {
    if (!system_->is_cube(i)) return posed_bounds(system_->body(i).box, 0.0);
    const double radius = system_->body(i).radius() * (1.0 + bounds_rounding);
    return predicted_bounds(view_.center_at(i, 0.0), view_.center_at(i, 1.0),
                            Vec2::Constant(radius) + view_.bulge(i));
  };
  for (const auto& [i, j] : neighbours_.find(*system_, bounds_of)) {
    if (view_.is_still(i) && view_.is_still(j)) continue;
    if (std::ranges::binary_search(closed_pairs_, IndexPair(i, j))) continue;
    EventFunction f{Kind::separation, i, j};
    f.arming.zero = zero(f);
    candidates_.push_back(f);
  }
}

void GeometricEvents::search(const EventFunction& f, Search& result) const {
  FunctionInStep in_step{view_, f};
  const double end = result.first ? result.first->share : 1.0;
  const FirstZero found = first_zero(in_step, end, f.arming);
  if (found.given_up) ++result.given_up;
  if (!found.share) return;
  result.first = {*found.share, f};
  result.first->function.arming = found.arming;
}

bool GeometricEvents::watches() const { return !functions_.empty() || box_count(*system_) > 1; }

GeometricEvents::Search GeometricEvents::first(const DenseStep& motion,
                                               double length,
                                               const std::vector<TwistRange>& range) {
  Search result;
  if (!watches()) return result;
  view_.set(motion, length, range);
  for (const EventFunction& f : functions_)
    search(f, result);
  find_candidates();
  for (EventFunction& f : candidates_) {
    const auto touching = std::ranges::lower_bound(touching_, f.pair(), {}, &EventFunction::pair);
    if (touching != touching_.end() && touching->pair() == f.pair()) f.arming = touching->arming;
    search(f, result);
  }
  return result;
}

void GeometricEvents::passed(const State& state) {
  for (EventFunction& f : functions_) {
    if (f.arming.shift != 0.0) f.arming.pass(value_at(*system_, state, f).value);
  }
  std::erase_if(touching_, [&](const EventFunction& f) {
    return f.arming.has_left_zero(value_at(*system_, state, f).value);
  });
}

}  // namespace wuerfel
