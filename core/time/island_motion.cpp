#include "core/time/island_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/dynamics/rod_rows.h"
#include "core/geometry/union_find.h"
#include "core/time/promises.h"

namespace wuerfel {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();

// Units of L / V.
constexpr double shortest_window = 0.05;
constexpr double longest_window = 8.0;
constexpr double first_window = 0.5;
/// Prediction of sweeps: this much of the path of free flight.
constexpr double sweep_reserve = 1.2;
/// What the tolerance promises of energy, per L / V: times that of all that moves or hangs.
constexpr double drift_share = 10.0;
/// What steps may leave unexplained of the energy that moved, or was lost.
constexpr double stepped_drift_share = 1e-4;
/// By how much the loss of a step that is under way may differ from an even one: what slows down to rest within it
/// loses s (2 - s) of it up to a share s.
constexpr double uneven_share = 0.25;
/// Cubes within this share of their half diagonal belong together.
constexpr double margin_share = 1e-3;

/// The whole system without the cubes that are not named.
System part_of(const System& whole, const std::vector<int>& cubes) {
  System part;
  part.title = whole.title;
  part.gravity = whole.gravity;
  part.cubes = static_cast<int>(cubes.size());
  part.pairs = whole.pairs;
  part.rubs = whole.rubs;
  part.bounces = whole.bounces;
  for (const int cube : cubes)
    part.bodies.push_back(whole.body(cube));
  part.bodies.insert(part.bodies.end(), whole.bodies.begin() + whole.cubes, whole.bodies.end());
  part.points = static_cast<int>(std::ranges::count(part.bodies, BodyKind::point, &Body::kind));
  part.strangers = whole.strangers;
  // Rods join cubes of one part only.
  const auto number_in_part = [&](RodEnd& end) {
    if (end.body < 0) return true;
    const auto at = std::ranges::lower_bound(cubes, end.body);
    if (at == cubes.end() || *at != end.body) return false;
    end.body = static_cast<int>(at - cubes.begin());
    return true;
  };
  for (Rod rod : whole.rods)
    if (number_in_part(rod.i) && number_in_part(rod.j)) part.rods.push_back(std::move(rod));
  return part;
}

/// What has been added after the first `known`; what happened at one time keeps its order.
template <typename Entry>
void sort_by_time(std::vector<Entry>& list, std::size_t known) {
  if (list.size() - known < 2) return;
  std::ranges::stable_sort(list.begin() + static_cast<std::ptrdiff_t>(known), list.end(), {},
                           &Entry::t);
}

/// How far bodies fall before something stops them, as a scale, m: L, or, where rods hold them, how far these reach.
double free_fall(const System& system, const State& start, const Scales& scales) {
  if (system.rods.empty()) return scales.length;
  BoundingBox bounds{start.front().position, start.front().position};
  const auto include = [&](const Vec2& p) {
    bounds = {bounds.low.cwiseMin(p), bounds.high.cwiseMax(p)};
  };
  for (const BodyState& s : start)
    include(s.position);
  for (const Rod& rod : system.rods) {
    include(held_place(rod.i, start).p);
    include(held_place(rod.j, start).p);
  }
  return std::max(scales.length, (bounds.high - bounds.low).norm());
}

}  // namespace

IslandMotion::IslandMotion(const System& system, const MotionSettings& settings, const State& start)
    : system_(&system), settings_(settings) {
  set_units(start);
  length_ = first_window * scales_.time;
  momentum_ = momentum_scale(system, start, scales_.speed);
  resting_.assign(start.size(), 0);
  stepping_.resize(start.size());
  // At the start bodies touch by the scene's tolerance; those that do belong together.
  predict(start, 0.0);
  std::vector<std::vector<int>> parts;
  partition(parts);
  regroup(start, parts);
  commit();
  advance_to(0.0);
}

IslandMotion::IslandMotion(const System& system,
                           const MotionSettings& settings,
                           const State& start,
                           const RestartPoint& point)
    : system_(&system),
      settings_(settings),
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
  in_motion_ =
      kinetic_energy(*system_, start) + scales_.weight * free_fall(*system_, start, scales_);
  budget_ = drift_share * settings_.tolerance * in_motion_;
  bounds_.resize(start.size());
  group_of_.assign(start.size(), -1);
}

void IslandMotion::advance_to(double t) {
  while (end_ <= t && t > 0.0)
    next_window();
  // What was seen when all had come to rest is what is seen later.
  if (time_ < still_since_) shown_state_.clear();
  time_ = t;
  const auto& events = computed_.events;
  for (; next_event_ < events.size() && events[next_event_].t <= t; ++next_event_)
    shown_.events.push_back(events[next_event_]);
  const auto& losses = computed_.losses;
  for (; next_loss_ < losses.size() && losses[next_loss_].t <= t; ++next_loss_)
    (losses[next_loss_].friction ? friction_loss_ : impact_loss_) += losses[next_loss_].energy;
}

const State& IslandMotion::state() {
  if (shown_state_.empty()) shown_state_ = state_at(time_);
  return shown_state_;
}

const Bookkeeping& IslandMotion::book() {
  double friction = friction_loss_;
  double under_way = 0.0;
  for (std::size_t k = next_loss_; k < computed_.losses.size(); ++k) {
    const Loss& loss = computed_.losses[k];
    if (!loss.friction || loss.since >= time_) continue;
    friction += loss.by(time_);
    under_way += loss.energy;
  }
  shown_.audit = computed_.audit;
  shown_.audit.impact_loss = impact_loss_;
  shown_.audit.friction_loss = friction;
  shown_.cost = computed_.cost;
  const bool stepped = policy_of(settings_).only_steps || computed_.cost.hand_overs > 0
                       || system_->rubs || system_->bounces;
  shown_.audit.drift_budget = stepped ? stepped_drift_share * (in_motion_ + impact_loss_ + friction)
                                            + uneven_share * under_way
                                      : budget_ * (1.0 + time_ / scales_.time);
  shown_.audit.momentum_budget = stepped ? promised_momentum_of_steps : promised_momentum;
  shown_.breaches = computed_.breaches;
  return shown_;
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

/// Bounds of what the cubes may sweep within `length` s.
void IslandMotion::predict(const State& state, double length) {
  const Vec2 g = system_->gravity;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Body& body = system_->bodies[i];
    const BodyState& s = state[i];
    if (length == 0.0 || resting_[i] != 0) {
      const Box box = make_box(s.position, s.angle, body.size);
      bounds_[i] = posed_bounds(box, margin_share * box.smaller_side());
      continue;
    }
    const double radius = (0.5 + margin_share) * body.size.norm();
    const Vec2 free = length * s.velocity + 0.5 * length * length * g;
    // Where contacts act a cube may go anywhere within what its speed and gravity allow.
    const double reach =
        (sweep_reserve - 1.0) * (length * s.velocity.norm() + 0.5 * length * length * g.norm());
    bounds_[i] = predicted_bounds(s.position, s.position + free, Vec2::Constant(radius + reach));
  }
}

/// Groups of cubes whose bounds overlap, in the order of their first cube.
void IslandMotion::partition(std::vector<std::vector<int>>& parts) {
  UnionFind sets(static_cast<int>(bounds_.size()));
  for (const IndexPair& pair : broad_phase_.overlapping_pairs(bounds_))
    sets.unite(pair.first, pair.second);
  for (const Rod& rod : system_->rods)
    if (!is_held(rod)) sets.unite(rod.i.body, rod.j.body);
  for (int i = 1; !settings_.skips.islands && i < static_cast<int>(bounds_.size()); ++i)
    sets.unite(0, i);
  parts.clear();
  std::vector<int> number(bounds_.size(), -1);
  for (int i = 0; i < static_cast<int>(bounds_.size()); ++i) {
    int& k = number[sets.root(i)];
    if (k < 0) {
      k = static_cast<int>(parts.size());
      parts.emplace_back();
    }
    parts[k].push_back(i);
  }
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
  std::vector<std::vector<int>> least;
  std::vector<std::vector<int>> parts;
  predict(state, shortest);
  partition(least);
  double length = std::min(2.0 * length_, longest_window * scales_.time);
  for (; length > shortest; length *= 0.5) {
    predict(state, length);
    partition(parts);
    if (parts == least) break;
  }
  length_ = std::max(length, shortest);
  regroup(state, least);
}

/// Groups that stay the same go on; others begin anew from `state`.
void IslandMotion::regroup(const State& state, const std::vector<std::vector<int>>& parts) {
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
  group.track = std::make_unique<Track>(whole ? *system_ : *group.system, settings_);
  State part;
  std::vector<char> rests;
  Track::Stepping stepping;
  for (const int i : cubes) {
    part.push_back(state[i]);
    rests.push_back(resting_[i]);
    stepping = later(stepping, stepping_[i]);
  }
  const double touching = begin_ == 0.0 ? touching_tolerance : 0.0;
  group.track->start(part, begin_, touching, std::move(rests), stepping);
}

void IslandMotion::move_groups() {
  const State state = state_at(begin_);
  while (true) {
    // One group alone meets nobody: it need not stop at the end of a window.
    const bool alone = groups_.size() == 1;
    end_ = begin_ + length_;
    double limit = end_;
    if (alone) limit = forever;
    for (Group& group : groups_) {
      Track& track = *group.track;
      while (track.clock() < end_) {
        beat();
        work_ += static_cast<long>(group.cubes.size());
        track.advance(limit);
      }
      if (alone) end_ = track.clock();
    }
    if (alone || !join_those_that_met(state)) return;
  }
}

/// Joins groups whose sweeps overlap and puts them back to the start of the window; false where
/// there are none.
bool IslandMotion::join_those_that_met(const State& state) {
  for (std::size_t i = 0; i < bounds_.size(); ++i)
    bounds_[i] = {state[i].position, state[i].position};
  std::vector<BoundingBox> part;
  for (const Group& group : groups_) {
    part.assign(group.cubes.size(), {Vec2::Constant(forever), Vec2::Constant(-forever)});
    group.track->sweep(begin_, part);
    for (std::size_t m = 0; m < part.size(); ++m)
      bounds_[group.cubes[m]] = part[m];
  }
  UnionFind sets(static_cast<int>(groups_.size()));
  bool met = false;
  for (const IndexPair& pair : broad_phase_.overlapping_pairs(bounds_)) {
    const int a = group_of_[pair.first];
    const int b = group_of_[pair.second];
    met = sets.unite(a, b) || met;
  }
  if (!met) return false;
  std::vector<std::vector<int>> parts(groups_.size());
  for (std::size_t i = 0; i < group_of_.size(); ++i)
    parts[sets.root(group_of_[i])].push_back(static_cast<int>(i));
  std::erase_if(parts, [](const std::vector<int>& p) { return p.empty(); });
  std::ranges::sort(parts);
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
  sort_by_time(computed_.events, first);
  sort_by_time(computed_.losses, first_loss);
  note_unexplained(momentum_, computed_);
}

}  // namespace wuerfel
