#include "core/time/stepping/overlap_removal.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

/// Gaps are kept open by so much, so that nothing like rounding is ever pushed out, or, in units of
/// its square, by what a step of Newton's method is expected to leave of an overlap. Both are
/// bounded by a share of the fall within a step: they must not be felt as a velocity.
constexpr double margin_share = 5e-11;
constexpr double margin_of_fall = 1e-6;
constexpr double margin_of_square = 4.0;
constexpr double square_of_fall = 1e-2;

constexpr int most_rounds = 8;
/// A clean-up looks at pairs nearer to each other than so many times the deepest overlap, but no
/// nearer and no farther apart than these shares of the smaller side.
constexpr double pushed_times = 20.0;
constexpr double nearest_share = 1e-7;
constexpr double farthest_share = 1e-2;
/// Displacements beyond this share of the smallest side, and beyond so many times the overlap, are
/// no clean-up any more.
constexpr double displaced_share = 1e-2;
constexpr double displaced_times = 100.0;
constexpr int most_halvings = 50;

/// A step is as exact as its length allows, not as its programs are. Steps of Newton's method only
/// have to get out of the overlap.
constexpr ProgramTolerances tolerances{.correction = 1e-3, .placement = 1e-5};

}  // namespace

OverlapRemoval::OverlapRemoval(const System& system, const MotionSettings& settings)
    : system_(&system), dynamics_(system, settings, tolerances), near_(system) {}

void OverlapRemoval::begin(const State& start, double h) {
  scales_ = scales_of(*system_, start);
  h_ = h;
  left_ = 0.0;
  start_ = start;
  near_.begin(start, h, scales_.gravity);
}

double OverlapRemoval::margin(const Contact& c, double overlap) const {
  const double fall = scales_.gravity * h_ * h_;
  const double scale = contact_scale(*system_, c);
  return std::max(std::min(margin_share * scale, margin_of_fall * fall),
                  std::min(margin_of_square * overlap * overlap * scale, square_of_fall * fall));
}

/// Per contact: what moves is what overlaps, the lighter the farther, and turns by as much.
std::vector<double> OverlapRemoval::margins_of(const Island& island) const {
  std::vector<double> moves(static_cast<std::size_t>(system_->count()), 0.0);
  const auto ease = [&](int body) {
    return system_->is_cube(body) ? 1.0 / system_->body(body).mass : 0.0;
  };
  for (const Contact& c : island.contacts) {
    const double overlap = -c.gap / contact_scale(*system_, c);
    for (const int body : {c.on, c.from})
      moves[body] = std::max(moves[body], overlap * ease(body) / (ease(c.on) + ease(c.from)));
  }
  std::vector<double> margins;
  for (const Contact& c : island.contacts)
    margins.push_back(margin(c, moves[c.on] + moves[c.from]));
  return margins;
}

Island OverlapRemoval::with_margins(Island island) const {
  const std::vector<double> margins = margins_of(island);
  for (std::size_t k = 0; k < margins.size(); ++k)
    island.contacts[k].gap -= margins[k];
  return island;
}

IslandSolution OverlapRemoval::apart(Island island,
                                     const State& state,
                                     std::span<const Twist> targets,
                                     Bookkeeping& book) {
  use_.assign(island.contacts.size(), SideUse::inequality);
  const std::vector<double> margins = margins_of(island);
  for (std::size_t k = 0; k < margins.size(); ++k)
    island.contacts[k].gap -= margins[k];
  IslandSolution solution = dynamics_.correction(state, island, use_, targets);
  ++book.cost.qp_solves;
  if (solution.status == QpStatus::optimal) return solution;
  // No room for the margin, perhaps: cubes that fit exactly between others.
  for (std::size_t k = 0; k < margins.size(); ++k)
    island.contacts[k].gap += margins[k];
  ++book.cost.qp_solves;
  return dynamics_.correction(state, island, use_, targets);
}

double OverlapRemoval::measure(const State& state) {
  finder_.find(*system_, state, overlapping_, 0.0);
  return finder_.deepest().depth / finder_.deepest().scale;
}

void OverlapRemoval::clean_up(State& state, std::vector<Contact>& pushing, Bookkeeping& book) {
  for (int round = 0; round <= most_rounds; ++round) {
    left_ = measure(state);
    if (left_ <= overlap_share || round == most_rounds) return;
    const double farthest = std::max(displaced_share, displaced_times * left_);
    const double reach = std::clamp(pushed_times * left_, nearest_share, farthest_share);
    near_.find_at(state, reach, contacts_);
    find_islands(*system_, contacts_, islands_);
    for (const Island& island : islands_) {
      const bool off = std::ranges::any_of(island.contacts, [&](const Contact& c) {
        return c.gap < -overlap_share * contact_scale(*system_, c);
      });
      if (!off) continue;
      const IslandSolution solution = apart(island, state, {}, book);
      if (std::ranges::any_of(solution.twists, [&](const Twist& d) {
            return d.linear.norm() > farthest * scales_.length;
          }))
        return;
      displace(island, solution.twists, state);
      for (std::size_t k = 0; k < island.contacts.size(); ++k) {
        if (solution.forces[k] > 0.0) pushing.push_back(island.contacts[k]);
      }
    }
  }
}

/// Per cube: whether it overlaps another body, by the last measurement.
std::vector<char> OverlapRemoval::overlapping_cubes() const {
  std::vector<char> overlaps(system_->cubes, 0);
  for (const Contact& c : overlapping_) {
    for (const int body : {c.on, c.from}) {
      if (system_->is_cube(body)) overlaps[body] = 1;
    }
  }
  return overlaps;
}

void OverlapRemoval::retreat(State& state) {
  for (int k = 1; k <= most_halvings; ++k) {
    left_ = measure(state);
    if (left_ <= overlap_share) return;
    const std::vector<char> overlaps = overlapping_cubes();
    near_.find_at(state, farthest_share, contacts_);
    find_islands(*system_, contacts_, islands_);
    const double share = k < most_halvings ? 0.5 : 0.0;
    for (const Island& island : islands_) {
      const bool stops =
          std::ranges::any_of(island.cubes, [&](int cube) { return overlaps[cube] != 0; });
      if (!stops) continue;
      for (const int cube : island.cubes) {
        const auto i = static_cast<std::size_t>(cube);
        state[i].position = start_[i].position + share * (state[i].position - start_[i].position);
        state[i].angle = start_[i].angle + share * (state[i].angle - start_[i].angle);
      }
    }
  }
  left_ = measure(state);
}

}  // namespace wuerfel
