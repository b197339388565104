#include "core/time/stepping/overlap_removal.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/rod_rows.h"

namespace wuerfel {
namespace {

/// Gaps are kept open by so much, so that nothing like rounding is ever pushed out, or by the square of what bodies move,
/// which is what a step of Newton's method leaves of an overlap. Both are bounded by a share of the fall within a step:
/// they must not be felt as a velocity.
constexpr double margin_share = 5e-11;
constexpr double margin_of_fall = 1e-6;
constexpr double square_of_fall = 1e-2;

constexpr int most_clean_ups = 8;
/// A clean-up looks at pairs nearer to each other than so many times the deepest overlap, but no
/// nearer than this share of the smaller side, and no farther apart than near_share.
constexpr double pushed_times = 20.0;
constexpr double nearest_share = 1e-7;
/// Displacements beyond what counts as near, and beyond so many times the overlap or what rods miss, are no clean-up any
/// more.
constexpr double displaced_times = 100.0;
constexpr int most_halvings = 50;

}  // namespace

ProgramTolerances step_tolerances(const System& system) {
  const double correction = system.rubs ? QpSettings{}.tolerance : 1e-3;
  return {.impact = 1e-6, .correction = correction, .placement = 1e-5};
}

void OverlapRemoval::begin(const State& start, double h) {
  scales_ = scales_of(*system_, start);
  h_ = h;
  left_ = 0.0;
  start_ = start;
  near_.begin(start, h, scales_.gravity);
}

double OverlapRemoval::margin(const Contact& c, double move) const {
  const double fall = scales_.gravity * h_ * h_;
  const double scale = contact_scale(*system_, c);
  return std::max(std::min(margin_share * scale, margin_of_fall * fall),
                  std::min(move * move * scale, square_of_fall * fall));
}

/// Margins, per contact: the largest push that the overlaps of an island ask for goes through all of it. What it meets
/// moves, the lighter the farther, but by no more than there is overlap, and turns by as much. Against friction only gaps
/// of what overlaps itself are opened, so that what rests stays where it is.
Restricted OverlapRemoval::apart(Island island) const {
  const auto ease_of = [&](int body) {
    return system_->is_cube(body) ? 1.0 / system_->body(body).mass : 0.0;
  };
  const auto ease = [&](const Contact& c) { return ease_of(c.on) + ease_of(c.from); };
  double deepest = 0.0;
  double push = 0.0;
  std::vector<double> overlap;
  for (const Contact& c : island.contacts) {
    overlap.push_back(std::max(0.0, -c.gap / contact_scale(*system_, c)));
    deepest = std::max(deepest, overlap.back());
    push = std::max(push, overlap.back() / ease(c));
  }
  const bool rubbing = rubs(*system_, island);
  Restricted part{std::move(island), {}};
  part.use.assign(overlap.size(), SideUse::inequality);
  for (std::size_t k = 0; k < overlap.size(); ++k) {
    const Contact& c = part.island.contacts[k];
    const double move = rubbing ? 2.0 * overlap[k] : std::min(deepest, 0.5 * push * ease(c));
    const double open = margin(c, move);
    part.margins.push_back(rubbing && overlap[k] <= closed_gap ? std::min(open, c.gap) : open);
  }
  return part;
}

double OverlapRemoval::measure(const State& state, double tolerance) {
  const ContactFinder::Overlap& deepest = work_->finder.deepest();
  found_ = work_->finder.find(*system_, state, tolerance);
  return deepest.depth / deepest.scale;
}

/// Islands near to what overlaps, by the last measurement.
std::vector<Restricted> OverlapRemoval::pushed_apart(const State& state) {
  const double reach = std::clamp(pushed_times * left_, nearest_share, near_share);
  const std::vector<Contact> near = near_.find_at(work_->finder.boxes(), reach);
  std::vector<Restricted> parts;
  for (Island& island : find_islands(*system_, near)) {
    if (!overlaps(*system_, island, overlap_share) && keeps_lengths(state, island.rods)) continue;
    parts.push_back(apart(std::move(island)));
    double missed = left_ * scales_.length;
    for (const int rod : parts.back().island.rods)
      missed = std::max(missed, std::abs(rod_excess(system_->rods[rod], state)));
    parts.back().farthest = std::max(near_share * scales_.length, displaced_times * missed);
  }
  return parts;
}

bool OverlapRemoval::keeps_lengths(const State& state, std::span<const int> rods) const {
  return std::ranges::all_of(
      rods, [&](int rod) { return has_length(*system_, state, system_->rods[rod]); });
}

bool OverlapRemoval::keeps_lengths(const State& state) const {
  return std::ranges::all_of(system_->rods,
                             [&](const Rod& rod) { return has_length(*system_, state, rod); });
}

std::vector<Contact> OverlapRemoval::clean_up(State& state, Bookkeeping& book) {
  const auto find = [&](const Projection& so_far) {
    left_ = measure(so_far.state, touching_share);
    const bool fits = left_ <= overlap_share && keeps_lengths(so_far.state);
    return fits ? std::vector<Restricted>{} : pushed_apart(so_far.state);
  };
  const ProjectionPolicy policy{.overlap = overlap_share, .rounds = most_clean_ups};
  Projection clean = project_places(*system_, std::move(state), policy, find, work_->dynamics);
  keep_cost(clean.solves, book);
  state = std::move(clean.state);
  if (clean.rounds == most_clean_ups || clean.too_far) left_ = measure(state, touching_share);
  return std::move(clean.pushing);
}

/// Per cube: whether it overlaps another body, by the last measurement.
std::vector<char> OverlapRemoval::overlapping_cubes() const {
  std::vector<char> overlaps(system_->cubes, 0);
  for (const Contact& c : found_) {
    for (const int body : {c.on, c.from}) {
      if (system_->is_cube(body)) overlaps[body] = 1;
    }
  }
  return overlaps;
}

void OverlapRemoval::retreat(State& state) {
  for (int k = 1; k <= most_halvings && measure(state, 0.0) > overlap_share; ++k) {
    const std::vector<char> overlaps = overlapping_cubes();
    std::vector<Contact> near = near_.find_at(work_->finder.boxes(), near_share);
    // Who came farther than its speed foretold meets pairs that nobody expected.
    near.insert(near.end(), found_.begin(), found_.end());
    const double share = k < most_halvings ? 0.5 : 0.0;
    for (const Island& island : find_islands(*system_, near)) {
      const bool stops =
          std::ranges::any_of(island.cubes, [&](int cube) { return overlaps[cube] != 0; });
      if (!stops) continue;
      for (const int cube : island.cubes) {
        BodyState& s = state[cube];
        s.position = start_[cube].position + share * (s.position - start_[cube].position);
        s.angle = start_[cube].angle + share * (s.angle - start_[cube].angle);
      }
    }
  }
  left_ = measure(state, touching_share);
}

}  // namespace wuerfel
