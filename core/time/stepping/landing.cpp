#include "core/time/stepping/landing.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/contact_rows.h"
#include "core/dynamics/impact.h"
#include "core/dynamics/momentum.h"
#include "core/time/stepping/step_books.h"

namespace wuerfel {
namespace {

/// What closes by no more g h in the second half doesn't bounce: what rests closes by half of one, by one where the first half
/// was taken back.
constexpr double bounce_steps = 1.0;
constexpr double anew_bounce_steps = 1.5;

}  // namespace

Landing::Landing(Workspace& work, OverlapRemoval& removal, RestingIslands& resting)
    : system_(work.system), work_(&work), removal_(&removal), resting_(&resting) {}

void Landing::find_touching(Stride& stride, Bookkeeping& book) {
  stride_ = &stride;
  contacts_ = removal_->touching();
  note_overlap(work_->finder.deepest().depth, work_->finder.deepest().scale, book.audit);
  std::erase_if(contacts_, [&](const Contact& c) { return is_covered(*system_, c); });
  const std::vector<ContactId> found = sorted_ids(contacts_);
  for (auto& [id, blow] : stride_->blows) {
    blow.end = at_poses(*system_, work_->finder.boxes(), blow.start);
    if (!std::ranges::binary_search(found, id)
        && std::abs(blow.end.gap) < pressed_share * contact_scale(*system_, blow.end))
      contacts_.push_back(blow.end);
  }
  add_blows(*system_, removal_->near().start_boxes(), contacts_, *stride_);
}

/// What bounces is judged by the speed at which it closes: a blow that the placement has taken it from is left to the
/// impact law, and so is what others have done against it. Where rods pass blows on, what others and they did is not taken back.
void Landing::strike_anew(State& state) {
  const std::vector<ContactId> near = sorted_ids(contacts_);
  const auto is_far = [&](const Contact& c) { return !std::ranges::binary_search(near, c.id()); };
  const auto bounces = [&](const Contact& c) {
    const Contact& start = stride_->blows.at(c.id()).start;
    return system_->surface(start.on, start.from).restitution > 0.0
           && closing_speed(*system_, *stride_, start) > impact_steps;
  };
  for (const Island& island : find_islands(*system_, acting(*stride_))) {
    const bool joined = !island.rods.empty();
    std::vector<Contact> anew = island.contacts;
    std::erase_if(anew, [&](const Contact& c) { return is_far(c) || (joined && !bounces(c)); });
    if (std::ranges::none_of(anew, bounces)) continue;
    take_back(anew, state);
    // Without them others, as in a wedge, push too hard.
    if (is_faster_than_free(island, state)) take_back(island.contacts, state);
  }
}

/// Takes first impulses of an island back, where the cubes are now: both have that place in common, so that no turning
/// is left behind. Arms have turned since the start; so much of them is taken that the energy comes back that they took.
void Landing::take_back(const std::vector<Contact>& contacts, State& state) {
  double due = 0.0;
  double linear = 0.0;
  State change(state.size());
  for (const Contact& c : contacts) {
    Blow& blow = stride_->blows.at(c.id());
    due -= first_work(*system_, *stride_, blow).sum();
    linear -= blow.first.dot(relative_velocity(*system_, stride_->before, c));
    push(*system_, c, -blow.first, change);
  }
  // quadratic s^2 + linear s = due
  const double quadratic = kinetic_energy(*system_, change);
  const double root = linear * linear + 4.0 * quadratic * due;
  const double share =
      quadratic > 0.0 && root >= 0.0 ? (std::sqrt(root) - linear) / (2.0 * quadratic) : 1.0;
  for (const Contact& c : contacts) {
    Blow& blow = stride_->blows.at(c.id());
    push(*system_, c, -share * blow.first - blow.second, state);
    blow.second = -share * blow.first;
    blow.taken_back = true;
  }
}

/// Whether an island has more energy in motion than if nothing had touched it since the start.
bool Landing::is_faster_than_free(const Island& island, const State& state) const {
  double has = 0.0;
  double free = 0.0;
  for (const int cube : island.cubes) {
    BodyState s = stride_->start[cube];
    s.velocity += stride_->h * system_->gravity;
    free += kinetic_energy(system_->body(cube), s);
    has += kinetic_energy(system_->body(cube), state[cube]);
  }
  return has > free;
}

void Landing::strike(State& state, Bookkeeping& book) {
  if (system_->bounces) strike_anew(state);
  hit(state, book);
  resting_->find(*stride_, islands_, state);
}

/// Whether nobody has come to an island that has not moved: what is left of gravity is held.
bool Landing::rests(const Island& island, State& state) {
  const RestingIsland* resting = resting_->skipped(island, stride_->start);
  if (resting == nullptr || !rests_at(*resting, stride_->half) || !is_at(*resting, state))
    return false;
  for (const int cube : resting->cubes)
    stop(state[cube]);
  for (std::size_t k = 0; k < resting->contacts.size(); ++k) {
    const Contact& c = resting->contacts[k];
    Blow& blow = stride_->blows.try_emplace(c.id(), Blow{c, c}).first->second;
    blow.second = 0.5 * stride_->h * resting->forces[k];
  }
  return true;
}

/// The impact law over all that touches, one island after the other.
void Landing::hit(State& state, Bookkeeping& book) {
  islands_ = find_islands(*system_, contacts_);
  const double fall = stride_->scales.gravity * stride_->h;
  const auto is_anew = [&](const Contact& c) { return stride_->blows.at(c.id()).taken_back; };
  for (const Island& island : islands_) {
    if (rests(island, state)) {
      ++book.cost.skipped_rest;
      continue;
    }
    if (!closes(*system_, state, island)) continue;
    const bool anew = island.rods.empty() && std::ranges::any_of(island.contacts, is_anew);
    const double slow = (anew ? anew_bounce_steps : bounce_steps) * fall;
    const IslandSolution after =
        impact(*system_, state, island, slow, work_->dynamics, work_->friction).after;
    keep_book(after, book);
    const double least = after.least_pressing();
    for (std::size_t k = 0; k < island.contacts.size(); ++k) {
      const Contact& c = island.contacts[k];
      if (after.forces[k] <= least) continue;
      const Vec2 impulse = impulse_at(c, after, k);
      push(*system_, c, impulse, state);
      stride_->blows.at(c.id()).second += impulse;
    }
    for (std::size_t k = 0; k < island.rods.size(); ++k) {
      stride_->rods_second[island.rods[k]] = after.rods[k];
      push(*system_, system_->rods[island.rods[k]], after.rods[k], stride_->before, state);
    }
  }
}

}  // namespace wuerfel
