#include "core/time/stepping/step_books.h"

#include <algorithm>
#include <cmath>

#include "core/constraints/islands.h"
#include "core/dynamics/momentum.h"
#include "core/dynamics/rod_rows.h"

namespace wuerfel {
namespace {

/// What opens faster than so many g h does not last.
constexpr double opening_steps = 1e-2;

/// What the contacts of a component take from its energy, J.
struct Balance {
  double friction = 0.0;      ///< along sides
  double closing = 0.0;       ///< those that close
  double lasting = 0.0;       ///< those that were closed and stay so: the sway of the method, where
                              ///< nothing is struck
  double last_struck = -1.0;  ///< share of the step; none: -1
  std::vector<StepLoss> frictions{};  ///< of contacts that lose by it
};

/// Makes the losses of single contacts, which are positive, add up to what is taken on balance.
void balance(const Balance& sums, std::vector<StepLoss>& losses) {
  const bool struck = sums.last_struck >= 0.0;
  const double total = std::max(0.0, sums.closing + (struck ? sums.lasting : 0.0));
  const double booked = sum_of(losses);
  if (total > booked) {
    const double share = struck ? sums.last_struck : 1.0;
    losses.push_back({share, share, total - booked});
  } else if (booked > 0.0) {
    for (StepLoss& loss : losses)
      loss.energy *= total / booked;
  }
}

/// What friction takes on balance, by the contacts that lose, each while it acts.
void share_friction(double total,
                    const std::vector<StepLoss>& frictions,
                    std::vector<StepLoss>& losses) {
  const double booked = sum_of(frictions);
  for (StepLoss loss : frictions) {
    loss.energy *= total / booked;
    losses.push_back(loss);
  }
}

/// Adds a loss to those of the same time.
void add_loss(const StepLoss& loss, std::vector<StepLoss>& losses) {
  const auto same = std::ranges::find_if(losses, [&](const StepLoss& other) {
    return other.begin == loss.begin && other.end == loss.end;
  });
  same == losses.end() ? losses.push_back(loss) : void(same->energy += loss.energy);
}

int a_cube_of(const System& system, const Contact& c) {
  return system.is_cube(c.on) ? c.on : c.from;
}

/// Per cube the number of its component, -1 where it is in none: cubes that pushed one another or were moved apart.
std::vector<int> component_of(const System& system, const Stride& stride) {
  std::vector<IndexPair> acting;
  for (const auto& [id, blow] : stride.blows) {
    if (blow.acts() || blow.cleaned) acting.emplace_back(blow.end.on, blow.end.from);
  }
  return number_islands(system, acting);
}

/// Whether a contact that acts rubs and, at the end, does not slide. Where bodies bounce more energy is put right than fixed ones
/// could give momenta for.
bool sticks(const System& system, const Stride& stride, const Blow& blow, const State& end) {
  const Contact& c = blow.end;
  if (system.bounces || !blow.acts() || system.surface(c.on, c.from).friction == 0.0) return false;
  const double slip = relative_velocity(system, end, c).dot(perp(c.normal));
  return std::abs(slip) <= opening_steps * stride.scales.gravity * stride.h;
}

/// The components, and the fixed bodies that keep them.
std::vector<StepComponent> components_of(const System& system,
                                         const Stride& stride,
                                         const State& end,
                                         const std::vector<int>& component) {
  std::vector<StepComponent> components(component.empty() ? 0 : std::ranges::max(component) + 1);
  for (int cube = 0; cube < system.cubes; ++cube)
    if (component[cube] >= 0) components[component[cube]].cubes.push_back(cube);
  // A rod to a fixed place keeps nothing of the motion as it is.
  for (const Rod& rod : system.rods) {
    if (!is_held(rod)) continue;
    StepComponent& part = components[component[std::max(rod.i.body, rod.j.body)]];
    part.held_along = {Vec2::UnitX(), Vec2::UnitY()};
  }
  for (const auto& [id, blow] : stride.blows) {
    const Contact& c = blow.end;
    if (system.is_cube(c.on) && system.is_cube(c.from)) continue;
    const int k = component[a_cube_of(system, c)];
    if (k < 0 || !(blow.acts() || blow.cleaned || is_near(system, c, touching_share))) continue;
    std::vector<Vec2>& normals = components[k].held_along;
    normals.reserve(2);
    if (normals.size() < 2) normals.push_back(c.normal);
    if (sticks(system, stride, blow, end)) normals = {c.normal, perp(c.normal)};
  }
  return components;
}

/// Work of an impulse on the corner, where the relative velocity is `a` before it and `b` after it.
Work work_of(const Contact& c, const Vec2& impulse, const Vec2& a, const Vec2& b) {
  const Vec2 v = 0.5 * (a + b);
  const Vec2 t = perp(c.normal);
  return {impulse.dot(c.normal) * v.dot(c.normal), impulse.dot(t) * v.dot(t)};
}

/// Work of a rod in both halves. It would do none if its direction did not change within a step.
double work_of(const System& system, const Stride& stride, int number, const State& end) {
  const Rod& rod = system.rods[number];
  const double sign = (rod.i.body >= 0 ? 1.0 : 0.0) - (rod.j.body >= 0 ? 1.0 : 0.0);
  const double fall =
      -0.25 * stride.h * sign * rod_direction(rod, stride.start).dot(system.gravity);
  const double first = 0.5 * (rod_rate(rod, stride.start) + rod_rate(rod, stride.half)) + fall;
  const double second = 0.5 * (rod_rate(rod, stride.before) + rod_rate(rod, end));
  return stride.rods_first[number] * first + stride.rods_second[number] * second;
}

/// The share of the step at which a gap closes that does so at `closing` g h at the start; 1 where that is slower than an
/// impact.
double struck_at(const Stride& stride, const Blow& blow, double closing) {
  if (closing <= impact_steps) return 1.0;
  const double fall = stride.scales.gravity * stride.h * stride.h;
  return std::clamp(blow.start.gap / (closing * fall), 0.0, 1.0);
}

/// When in a step a contact acts, in shares of the step.
struct Timing {
  double begin = 0.0;
  double end = 1.0;
  bool struck = false;  ///< it closes as fast as an impact
  /// It is closed at the start and stays so: its work is the sway of the method. What opens at the start and acts all the
  /// same lands.
  bool lasts = false;
};

Timing timing_of(const System& system, const Stride& stride, const Blow& blow, const State& end) {
  const double closing = closing_speed(system, stride, blow.start);
  if (closing > impact_steps) {
    const double share = struck_at(stride, blow, closing);
    return {share, share, true, false};
  }
  if (blow.start.gap <= touching_share * contact_scale(system, blow.start)
      && closing >= -opening_steps)
    return {0.0, 1.0, false, true};
  // It lands: s^2 / 2 + c s = gap, in units of g h and g h^2.
  const double gap = std::max(0.0, blow.start.gap / (stride.scales.gravity * stride.h * stride.h));
  const double share = std::clamp(std::sqrt(closing * closing + 2.0 * gap) - closing, 0.0, 1.0);
  const double opening = relative_velocity(system, end, blow.end).dot(blow.end.normal)
                         / (stride.scales.gravity * stride.h);
  return {share, opening > opening_steps ? share : 1.0};
}

/// Whether the second impulse is a blow: where corners turn fast a place that was nearest to free flight may lead into it.
bool strikes_at_end(const System& system, const Stride& stride, const Blow& blow) {
  const double opening = relative_velocity(system, stride.before, blow.end).dot(blow.end.normal);
  return opening < -impact_steps * stride.scales.gravity * stride.h;
}

StepImpulse impulse_of(const System& system,
                       const Stride& stride,
                       const Blow& blow,
                       const State& end,
                       const Timing& timing) {
  const auto turn = [&](int body) {
    if (!system.is_cube(body)) return 0.0;
    return det(blow.start.point - stride.start[body].position, blow.first)
           + det(blow.end.point - end[body].position, blow.second);
  };
  const Contact& c = blow.end;
  return {c.on,         c.from,    blow.first + blow.second, turn(c.on), -turn(c.from),
          timing.begin, timing.end};
}

/// Where something is struck rods pass the blow on, and lose of it what their turning in the step takes; where they jam
/// what they take is lost.
void add_rods(const System& system,
              const Stride& stride,
              const State& end,
              const std::vector<int>& component,
              std::vector<Balance>& balances) {
  for (int number = 0; number < std::ssize(system.rods); ++number) {
    const Rod& rod = system.rods[number];
    const int k = component[rod.i.body >= 0 ? rod.i.body : rod.j.body];
    if (k < 0) continue;
    double& taken = stride.jammed.empty() ? balances[k].lasting : balances[k].closing;
    taken -= work_of(system, stride, number, end);
  }
}

/// The same as first_work in the second half, which leads to `end`.
Work second_work(const System& system, const Stride& stride, const Blow& blow, const State& end) {
  return work_of(blow.end, blow.second, relative_velocity(system, stride.before, blow.end),
                 relative_velocity(system, end, blow.end));
}

/// What a contact takes from its component: on balance, and as losses by themselves.
void take_blow(const System& system,
               const Stride& stride,
               const Blow& blow,
               const State& end,
               const Timing& timing,
               Balance& balance,
               std::vector<StepLoss>& losses) {
  const Work first = first_work(system, stride, blow);
  const Work second = second_work(system, stride, blow, end);
  const double loss = -first.normal - second.normal;
  const double rubbed = -first.side - second.side;
  balance.friction += rubbed;
  if (rubbed > 0.0) add_loss({timing.begin, timing.end, rubbed, true}, balance.frictions);
  (timing.lasts ? balance.lasting : balance.closing) += loss;
  if (!timing.lasts) losses.push_back({timing.begin, timing.end, std::max(0.0, loss)});
  if (timing.lasts && strikes_at_end(system, stride, blow)) losses.push_back({1.0, 1.0, 0.0});
  if (timing.struck) balance.last_struck = std::max(balance.last_struck, timing.end);
}

/// The losses of a component, from what its contacts took.
void lose(const System& system, Balance& sums, std::vector<StepLoss>& losses) {
  // What sides gain in a blow that its normals pay for is no friction; nor is, where nothing rubs, what they lose in one
  // that is taken back where its normal has turned.
  const bool of_blows = system.bounces && !system.rubs;
  sums.closing += of_blows ? sums.friction : std::min(sums.friction, 0.0);
  balance(sums, losses);
  if (system.rubs && sums.friction > 0.0) share_friction(sums.friction, sums.frictions, losses);
}

}  // namespace

Work first_work(const System& system, const Stride& stride, const Blow& blow) {
  const Contact& c = blow.start;
  // Half of the gravity of the first half is not the contact's.
  Vec2 fall = Vec2::Zero();
  if (system.is_cube(c.on) != system.is_cube(c.from))
    fall = (system.is_cube(c.on) ? -0.25 : 0.25) * stride.h * system.gravity;
  return work_of(c, blow.first, relative_velocity(system, stride.start, c) + fall,
                 relative_velocity(system, stride.half, c) + fall);
}

double sum_of(const std::vector<StepLoss>& losses) {
  double sum = 0.0;
  for (const StepLoss& loss : losses)
    sum += loss.energy;
  return sum;
}

StepRecord record_of(const System& system, const Stride& stride, const State& end) {
  const std::vector<int> component = component_of(system, stride);
  StepRecord record{{}, components_of(system, stride, end, component)};
  record.impulses.reserve(stride.blows.size());
  std::vector<Balance> balances(record.components.size());
  for (const auto& [id, blow] : stride.blows) {
    if (!blow.acts()) continue;
    const Timing timing = timing_of(system, stride, blow, end);
    record.impulses.push_back(impulse_of(system, stride, blow, end, timing));
    const int k = component[a_cube_of(system, blow.end)];
    take_blow(system, stride, blow, end, timing, balances[k], record.components[k].losses);
  }
  add_rods(system, stride, end, component, balances);
  for (std::size_t k = 0; k < balances.size(); ++k)
    lose(system, balances[k], record.components[k].losses);
  return record;
}

std::vector<Event> impacts_of(const System& system, const Stride& stride, double t) {
  std::vector<Event> events;
  for (const auto& [id, blow] : stride.blows) {
    if (!blow.acts()) continue;
    const double closing = closing_speed(system, stride, blow.start);
    if (closing <= impact_steps) continue;
    const Contact& c = blow.end;
    events.push_back({t + struck_at(stride, blow, closing) * stride.h, EventKind::impact,
                      system.body(c.on).name, system.body(c.from).name, c.point,
                      (blow.first + blow.second).dot(c.normal)});
  }
  std::ranges::stable_sort(events, {}, &Event::t);
  return events;
}

}  // namespace wuerfel
