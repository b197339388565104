#include "core/time/partial_motion.h"

#include <algorithm>
#include <utility>

#include "core/dynamics/impact.h"
#include "core/dynamics/instant_friction.h"
#include "core/dynamics/verdict.h"
#include "core/model/system_part.h"
#include "core/time/events/contact_modes.h"
#include "core/time/events/instant.h"
#include "core/time/track.h"

namespace wuerfel {
namespace {

/// So many cubes may move, and no more than half of the group. What more of them bring about on top of others are events without end.
constexpr std::ptrdiff_t most_moving = 6;

/// Takes the mark off those of an island that are not held where they are; false where accelerations are not known. An island of
/// which all stand rests, or it does not.
bool unmark_accelerated(const Island& island,
                        const State& state,
                        Workspace& work,
                        std::vector<char>& stands) {
  const auto is_marked = [&](int cube) { return stands[cube] != 0; };
  const auto marked = std::ranges::count_if(island.cubes, is_marked);
  if (marked == 0) return true;
  const bool all = marked == std::ssize(island.cubes);
  if (all && rests(island, state, scales_of(*work.system, state), {}, work)) return true;
  const IslandSolution solution = accelerations_at(island, state, work);
  if (solution.status != QpStatus::optimal) return false;
  const double most = falls_above * scales_of(*work.system, state).gravity;
  for (std::size_t k = 0; k < island.cubes.size(); ++k) {
    const int cube = island.cubes[k];
    if (size_of(work.system->body(cube), solution.twists[k]) > most) stands[cube] = 0;
  }
  return !(all && std::ranges::all_of(island.cubes, is_marked));
}

/// What is joined by rods stands or moves together.
void unmark_joined(const System& system, std::vector<char>& stands) {
  for (bool changed = true; changed;) {
    changed = false;
    for (const Rod& rod : system.rods) {
      if (is_held(rod) || stands[rod.i.body] == stands[rod.j.body]) continue;
      stands[rod.i.body] = stands[rod.j.body] = 0;
      changed = true;
    }
  }
}

/// Takes the mark off the cubes that something accelerates, or that nothing touches; false where it cannot be told.
bool unmark_moving(const std::vector<Island>& islands,
                   const State& state,
                   Workspace& work,
                   std::vector<char>& stands) {
  std::vector<char> touched(state.size(), 0);
  for (const Island& island : islands) {
    for (const int cube : island.cubes)
      touched[cube] = 1;
    if (!unmark_accelerated(island, state, work, stands)) return false;
  }
  for (std::size_t i = 0; i < state.size(); ++i)
    if (touched[i] == 0) stands[i] = 0;
  unmark_joined(*work.system, stands);
  return true;
}

std::vector<int> marked(const std::vector<char>& marks, bool mark) {
  std::vector<int> cubes;
  for (std::size_t i = 0; i < marks.size(); ++i)
    if ((marks[i] != 0) == mark) cubes.push_back(static_cast<int>(i));
  return cubes;
}

/// The cubes whose velocities do not count.
std::vector<char> still_cubes(const System& system, const State& state) {
  const double slow = ContactLimits{}.rest_speed * scales_of(system, state).speed;
  std::vector<char> still(state.size(), 0);
  for (int i = 0; i < system.cubes; ++i) {
    const Body& body = system.body(i);
    if (body.kind != BodyKind::point && fastest_corner(body, state[i]) <= slow) still[i] = 1;
  }
  return still;
}

/// Whether the others, that move, are few.
bool are_few(const std::vector<char>& stands) {
  return std::ranges::count(stands, 0) <= std::min(most_moving, std::ssize(stands) / 2);
}

/// Of the part no part is made.
MotionPolicy whole(MotionPolicy policy) {
  policy.parts = false;
  return policy;
}

}  // namespace

bool PartialMotion::few_move(const System& system, const State& state) {
  return are_few(still_cubes(system, state));
}

std::unique_ptr<PartialMotion> PartialMotion::find(const State& state,
                                                   double t,
                                                   double touching,
                                                   const MotionSettings& settings,
                                                   const MotionPolicy& policy,
                                                   Workspace& work) {
  const System& system = *work.system;
  std::vector<char> stands = still_cubes(system, state);
  if (!are_few(stands)) return {};
  State still = state;
  for (const int cube : marked(stands, true))
    stop(still[cube]);
  const std::vector<Island> islands = islands_at(still, touching, work);
  const auto is_struck = [&](const Island& island) { return closes(system, still, island); };
  if (std::ranges::any_of(islands, is_struck) || !unmark_moving(islands, still, work, stands)
      || !are_few(stands))
    return {};
  for (const int cube : marked(stands, false))
    still[cube] = state[cube];
  std::unique_ptr<PartialMotion> part(new PartialMotion(still, std::move(stands), touching, work));
  if (!part->begin(t, settings, policy)) part.reset();
  return part;
}

PartialMotion::PartialMotion(const State& state,
                             std::vector<char> stands,
                             double touching,
                             Workspace& work)
    : work_(&work),
      touching_(std::max(touching, event_touching)),
      moving_(marked(stands, false)),
      standing_(marked(stands, true)),
      system_(part_on(*work.system, moving_, standing_, state)),
      state_(state),
      resting_(std::move(stands)) {}

PartialMotion::~PartialMotion() = default;

bool PartialMotion::begin(double t, const MotionSettings& settings, const MotionPolicy& policy) {
  if (moving_.empty()) return false;
  track_ = std::make_unique<Track>(system_, settings, whole(policy));
  State part;
  for (const int cube : moving_)
    part.push_back(state_[cube]);
  track_->start(part, t, touching_, std::vector<char>(part.size(), 0), {});
  if (is_stepped() || !are_held()) return false;
  take_over();
  return true;
}

void PartialMotion::advance(double limit, Bookkeeping& book) {
  track_->advance(std::min(limit, clock_ + longest_step_));
  const double length = track_->clock() - clock_;
  goes_on_ = accept(book);
  refused_ = track_->clock() > clock_ ? length : 0.0;
  if (!goes_on_ || track_->blows().empty()) return;
  const std::optional<std::vector<Event>> passed_on = withstand(track_->blows());
  goes_on_ = passed_on.has_value();
  if (!goes_on_) return;
  goes_on_ = track_->take_blows() && accept(book);
  if (goes_on_) book.events.insert(book.events.end(), passed_on->begin(), passed_on->end());
}

/// Whether the others stand where those that move have come; only then it is part of the motion.
bool PartialMotion::accept(Bookkeeping& book) {
  const bool stand = are_held();
  keep_cost(std::exchange(work_->solves, {}), book);
  if (!stand) return false;
  add(std::exchange(track_->book(), {}), book);
  take_over();
  return !is_stepped();
}

/// How contacts of the others take away at once what blows to them, numbered as in the part, would make of them, as impacts at the
/// clock; none where they cannot.
std::optional<std::vector<Event>> PartialMotion::withstand(const std::map<int, Push>& blows) {
  const System& system = *work_->system;
  State pushed = state_;
  std::vector<char> moves(system.count(), 0);
  for (const int cube : moving_) {
    moves[cube] = 1;
    stop(pushed[cube]);
  }
  for (const auto& [number, blow] : blows) {
    const int cube = of_group(number);
    pushed[cube].velocity = blow.linear / system.body(cube).mass;
    pushed[cube].spin = blow.angular / system.body(cube).inertia;
  }
  std::vector<Contact> contacts = work_->finder.find(system, pushed, touching_);
  std::erase_if(contacts, [&](const Contact& c) { return moves[c.on] != 0 || moves[c.from] != 0; });
  std::vector<Island> islands = find_islands(system, contacts);
  add_free_cubes(system, islands);
  std::vector<Event> events;
  for (const Island& island : islands) {
    const auto is_unpushed = [&](int cube) { return is_still(pushed[cube]); };
    if (std::ranges::all_of(island.cubes, is_unpushed)) continue;
    const std::optional<IslandSolution> impulses = work_->friction.stopping(pushed, island);
    if (!impulses) return {};
    add_impact_events(system, island, *impulses, clock_, EventKind::impact, events);
  }
  return events;
}

bool PartialMotion::is_stepped() const { return track_->stepping().until >= 0.0; }

/// The number in the group of a body of the part: those that move come first, then those that stand, then what is fixed.
int PartialMotion::of_group(int body) const {
  const int moving = static_cast<int>(moving_.size());
  if (body < moving) return moving_[body];
  return body < work_->system->cubes ? standing_[body - moving] : body;
}

/// The step just taken is part of the motion.
void PartialMotion::take_over() {
  clock_ = track_->clock();
  state_ = with_others(track_->state());
  for (std::size_t k = 0; k < moving_.size(); ++k)
    resting_[moving_[k]] = track_->resting()[k];
}

/// Whether there are forces that hold the others where they are, and those of the part that rest, and under which the part moves
/// as it does: of a plank under which a cube slides it knows nothing.
bool PartialMotion::are_held() {
  std::vector<char> loose(state_.size(), 1);
  std::vector<Twist> accelerations(state_.size());
  for (const int cube : standing_)
    loose[cube] = 0;
  for (std::size_t k = 0; k < moving_.size(); ++k) {
    loose[moving_[k]] = track_->resting()[k] == 0 ? 1 : 0;
    if (loose[moving_[k]] != 0)
      accelerations[moving_[k]] = track_->acceleration(static_cast<int>(k));
  }
  const State state = with_others(track_->state());
  std::vector<char> touched = loose;
  for (const Island& island : islands_at(state, touching_, *work_)) {
    for (const int cube : island.cubes)
      touched[cube] = 1;
    if (!is_held(island, state, loose, accelerations)) return false;
  }
  return std::ranges::find(touched, 0) == touched.end();
}

bool PartialMotion::is_held(const Island& island,
                            const State& state,
                            const std::vector<char>& loose,
                            const std::vector<Twist>& accelerations) {
  const System& system = *work_->system;
  const auto moves = [&](int cube) { return loose[cube] != 0; };
  if (std::ranges::all_of(island.cubes, moves)) return true;
  if (std::ranges::none_of(island.cubes, moves)) {
    std::vector<int>& known = at_rest_[island.cubes.front()];
    if (known == island.cubes) return true;
    if (!rests(island, state, scales_of(system, state), {}, *work_)) return false;
    known = island.cubes;
    return true;
  }
  std::vector<Twist> of_cubes;
  for (const int cube : island.cubes)
    of_cubes.push_back(accelerations[cube]);
  return work_->friction.bears(state, island, resting_uses(system, state, island),
                               known_slips(system, state, island, rate_tolerance), of_cubes,
                               falls_above);
}

State PartialMotion::with_others(const State& part) const {
  State state = state_;
  for (std::size_t k = 0; k < moving_.size(); ++k)
    state[moving_[k]] = part[k];
  return state;
}

State PartialMotion::at(double t) { return t >= clock_ ? state_ : with_others(track_->at(t)); }

std::vector<Contact> PartialMotion::loaded_at(double t) const {
  std::vector<Contact> contacts = track_->loaded_at(t);
  for (Contact& c : contacts) {
    c.on = of_group(c.on);
    c.from = of_group(c.from);
  }
  return contacts;
}

bool PartialMotion::at_rest() const { return track_->at_rest(); }

void PartialMotion::forget_before(double t) { track_->forget_before(t); }

void PartialMotion::sweep(double t, std::vector<BoundingBox>& bounds) const {
  std::vector<BoundingBox> part;
  for (const int cube : moving_)
    part.push_back(bounds[cube]);
  track_->sweep(t, part);
  for (std::size_t k = 0; k < moving_.size(); ++k)
    bounds[moving_[k]] = part[k];
}

}  // namespace wuerfel
