#include "core/time/island_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/model/system_part.h"
#include "core/time/promises.h"

namespace wuerfel {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();
// Units of L / V.
constexpr double shortest_window = 1.0 / frames_per_time;
constexpr double longest_window = 8.0;
constexpr double first_window = 0.5;
/// A window ends after so many steps of a group, which are kept until then.
constexpr int most_pieces = 1000;

}  // namespace

IslandMotion::IslandMotion(const System& system, const MotionSettings& settings, const State& start)
    : system_(&system), settings_(settings), meetings_(system, settings.skips.islands) {
  set_units(start);
  length_ = first_window * scales_.time;
  momentum_ = momentum_scale(system, start, scales_.speed);
  resting_.assign(start.size(), 0);
  stepping_.resize(start.size());
  // At the start bodies touch by the scene's tolerance; those that do belong together.
  regroup(start, meetings_.within(start, resting_, 0.0));
  commit();
  advance_to(0.0);
}

IslandMotion::IslandMotion(const System& system,
                           const MotionSettings& settings,
                           const State& start,
                           const RestartPoint& point)
    : system_(&system),
      settings_(settings),
      meetings_(system, settings.skips.islands),
      resting_(point.resting),
      stepping_(point.stepping),
      begin_(point.t),
      end_(point.t),
      length_(point.window),
      momentum_(point.momentum),
      hash_(point.hash),
      time_(point.t),
      computed_(point.book) {
  set_units(start);
  resting_.resize(start.size());
  stepping_.resize(start.size());
  begin_window(point.state);
  move_groups();
  commit();
  advance_to(point.t);
}

void IslandMotion::set_units(const State& start) {
  scales_ = scales_of(*system_, start);
  energy_start_ = energy(*system_, start);
  drift_ = PromisedDrift(*system_, start, scales_, settings_.tolerance);
  group_of_.assign(start.size(), -1);
}

void IslandMotion::advance_to(double t) {
  while (end_ <= t && t > 0.0)
    next_window();
  // What was seen when all had come to rest is what is seen later.
  if (time_ < still_since_) shown_state_.clear();
  time_ = t;
  shown_.advance_to(t, computed_);
}

const State& IslandMotion::state() {
  if (shown_state_.empty()) shown_state_ = state_at(time_);
  return shown_state_;
}

const Bookkeeping& IslandMotion::book() {
  const double now = shown_.any_under_way(computed_) ? energy(*system_, state()) : energy_start_;
  const LostEnergy lost = shown_.lost(computed_, energy_start_ - now);
  Bookkeeping& book = shown_.book;
  Audit& audit = book.audit;
  audit = computed_.audit;
  audit.impact_loss = lost.impacts;
  audit.friction_loss = lost.friction;
  book.cost = computed_.cost;
  book.breaches = computed_.breaches;
  const bool stepped =
      policy_.only_steps || book.cost.hand_overs > 0 || system_->rubs || system_->bounces;
  audit.drift_budget =
      stepped ? drift_.of_steps(lost.impacts + lost.friction) : drift_.of_events(time_);
  audit.momentum_budget = stepped ? promised_momentum_of_steps : promised_momentum;
  const double settled = stepped ? promised_settled_in_steps(system_->bounces) : promised_settled;
  audit.settled_budget = settled * (1.0 + time_ / scales_.time);
  return book;
}

State IslandMotion::state_at(double t) {
  State state(group_of_.size());
  for (Group& group : groups_) {
    const State part = group.track->at(t);
    for (std::size_t k = 0; k < part.size(); ++k)
      state[group.cubes[k]] = part[k];
  }
  return state;
}

/// Contacts of a group, whose cubes are numbered among themselves, in the numbers of all bodies.
std::vector<Contact> IslandMotion::loaded() {
  std::vector<Contact> contacts;
  for (const Group& group : groups_) {
    const int cubes = static_cast<int>(group.cubes.size());
    const auto of_all = [&](int body) {
      return body < cubes ? group.cubes[body] : body - cubes + system_->cubes;
    };
    for (Contact c : group.track->loaded_at(time_)) {
      c.on = of_all(c.on);
      c.from = of_all(c.from);
      contacts.push_back(c);
    }
  }
  return contacts;
}

void IslandMotion::next_window() {
  const bool all_rest =
      std::ranges::all_of(groups_, [](const Group& g) { return g.track->at_rest(); });
  begin_ = end_;
  if (all_rest) {
    end_ = forever;
    still_since_ = begin_;
    for (Group& group : groups_) {
      if (group.track->clock() < forever) group.track->advance(forever);
    }
    commit();
    return;
  }
  const State state = end_window();
  if (work_ >= work_between_restarts) restart(state);
  begin_window(state);
  move_groups();
  commit();
}

/// The state at the end of the last window, and what is known of it.
State IslandMotion::end_window() {
  State state = state_at(begin_);
  momentum_.include(momentum_scale(*system_, state, scales_.speed));
  hash_.add(begin_, state);
  for (Group& group : groups_) {
    group.track->forget_before(begin_);
    for (std::size_t m = 0; m < group.cubes.size(); ++m) {
      const int cube = group.cubes[m];
      resting_[cube] = group.track->resting()[m];
      stepping_[cube] = group.track->stepping();
    }
  }
  return state;
}

/// Groups forget what they and their solvers remember: from here on the motion goes by what is told.
void IslandMotion::restart(const State& state) {
  groups_.clear();
  work_ = 0;
  if (listener())
    listener()({begin_, state, computed_, hash_, momentum_, length_, resting_, stepping_, 0});
}

void IslandMotion::begin_window(const State& state) {
  // The longest window in which nobody meets anybody who is not met in the shortest one either.
  const double shortest = shortest_window * scales_.time;
  const Parts least = meetings_.within(state, resting_, shortest);
  double length = std::min(2.0 * length_, longest_window * scales_.time);
  while (length > shortest && meetings_.within(state, resting_, length) != least)
    length *= 0.5;
  length_ = std::max(length, shortest);
  regroup(state, least);
}

/// Groups that stay the same go on; others begin anew from `state`.
void IslandMotion::regroup(const State& state, const Parts& parts) {
  std::map<int, std::size_t> by_first;
  for (std::size_t k = 0; k < groups_.size(); ++k)
    by_first[groups_[k].cubes.front()] = k;
  std::vector<Group> next(parts.size());
  std::vector<std::size_t> changed;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto same = by_first.find(parts[k].front());
    if (same != by_first.end() && groups_[same->second].cubes == parts[k]) {
      next[k].cubes = parts[k];
      std::swap(next[k].system, groups_[same->second].system);
      std::swap(next[k].track, groups_[same->second].track);
    } else {
      changed.push_back(k);
    }
  }
  for (const std::size_t k : changed)
    make_group(state, parts[k], next[k]);
  groups_ = std::move(next);
  for (std::size_t k = 0; k < groups_.size(); ++k) {
    for (std::size_t m = 0; m < groups_[k].cubes.size(); ++m) {
      const int cube = groups_[k].cubes[m];
      group_of_[cube] = static_cast<int>(k);
    }
  }
}

void IslandMotion::make_group(const State& state, const std::vector<int>& cubes, Group& group) {
  group.cubes = cubes;
  const bool whole = static_cast<int>(cubes.size()) == system_->cubes;
  if (!whole) group.system = std::make_unique<System>(part_of(*system_, cubes));
  group.track = std::make_unique<Track>(whole ? *system_ : *group.system, settings_, policy_);
  State part;
  std::vector<char> rests;
  Stepping stepping;
  for (const int i : cubes) {
    part.push_back(state[i]);
    rests.push_back(resting_[i]);
    stepping = later(stepping, stepping_[i]);
  }
  const double touching = begin_ == 0.0 ? touching_tolerance : 0.0;
  group.track->start(part, begin_, touching, std::move(rests), stepping);
}

/// To the end of the window, which ends where it takes too many pieces.
void IslandMotion::move(Group& group, double limit) {
  Track& track = *group.track;
  for (int pieces = 0; track.clock() < end_; ++pieces) {
    if (pieces == most_pieces) {
      end_ = track.clock();
      length_ = end_ - begin_;
      return;
    }
    beat();
    work_ += static_cast<long>(group.cubes.size());
    track.advance(limit);
  }
}

void IslandMotion::move_groups() {
  const State state = state_at(begin_);
  while (true) {
    // One group alone meets nobody: it need not stop at the end of a window.
    const bool alone = groups_.size() == 1;
    end_ = begin_ + length_;
    const double planned = end_;
    for (Group& group : groups_)
      move(group, alone ? forever : end_);
    if (!alone && end_ < planned) put_back(state);
    if (alone) end_ = groups_.front().track->clock();
    if (alone || !join_those_that_met(state)) return;
  }
}

/// Who has come farther than to the end of a window that was cut short is put back to its start: what happens later to him is
/// booked when it happens, whoever he belongs to by then.
void IslandMotion::put_back(const State& state) {
  for (Group& group : groups_) {
    if (group.track->clock() <= end_) continue;
    make_group(state, group.cubes, group);
    move(group, end_);
  }
}

/// Joins groups whose sweeps overlap and puts them back to the start of the window; false where
/// there are none.
bool IslandMotion::join_those_that_met(const State& state) {
  std::vector<BoundingBox> swept(group_of_.size());
  std::vector<BoundingBox> part;
  for (const Group& group : groups_) {
    part.assign(group.cubes.size(), {Vec2::Constant(forever), Vec2::Constant(-forever)});
    group.track->sweep(begin_, part);
    for (std::size_t m = 0; m < part.size(); ++m)
      swept[group.cubes[m]] = part[m];
  }
  const Parts parts = meetings_.joined(swept, group_of_, static_cast<int>(groups_.size()));
  if (parts.empty()) return false;
  regroup(state, parts);
  return true;
}

/// Takes the books of all groups over; events in the order of time.
void IslandMotion::commit() {
  const std::size_t first = computed_.events.size();
  const std::size_t first_loss = computed_.losses.size();
  for (Group& group : groups_) {
    Bookkeeping& book = group.track->book();
    add(book, computed_);
    book = {};
  }
  sort_by_time(first, first_loss, computed_);
  note_unexplained(momentum_, computed_);
}

}  // namespace wuerfel
