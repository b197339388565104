#include "core/time/reference/stepper.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/impact.h"
#include "core/model/points.h"

namespace wuerfel {
namespace {

/// Velocities that count as zero become zero, so that rest can be certified.
void settle(const System& system, const Island& island, State& state) {
  for (const int cube : island.cubes) {
    const BodyState& s = state[cube];
    const double side = system.body(cube).size.minCoeff();
    const double zero = rate_tolerance * std::sqrt(system.gravity.norm() * side);
    if (s.velocity.norm() + side * std::abs(s.spin) > zero) return;
  }
  for (const int cube : island.cubes) {
    state[cube].velocity.setZero();
    state[cube].spin = 0.0;
  }
}

bool is_still(const Island& island, const State& state) {
  return std::ranges::all_of(island.cubes, [&](int cube) {
    const BodyState& s = state[cube];
    return s.velocity.isZero(0.0) && s.spin == 0.0;
  });
}

}  // namespace

Stepper::Stepper(const System& system, const MotionSettings& settings)
    : system_(&system),
      settings_(settings),
      dynamics_(system, settings),
      correction_(system, settings) {}

bool Stepper::at_rest(const Moment& moment) {
  return std::ranges::all_of(moment.resting, [](char r) { return r != 0; });
}

void Stepper::step(Moment& moment, double dt, Bookkeeping& book) {
  // What rests altogether stays: not even its contacts are looked for.
  if (at_rest(moment)) {
    book.cost.skipped_rest += static_cast<long>(moment.islands.size());
    moment.t += dt;
    ++book.cost.steps;
    return;
  }
  // Bestimme die aktiven Restriktionen: done by `arrive` when this moment was reached.
  // Bestimme (a_i): Eq. (9) under (1) and under (7) where (2) = (3) = 0.
  std::vector<Contact> pressed;
  if (settings_.integrator == Integrator::moreau) {
    pressed = sweep(moment, dt, book);
  } else {
    accelerate(moment, book);
    pressed = pressed_contacts(moment);
    // v := v + a dt,  p := p + v dt
    integrate(moment, dt);
  }

  // Eventuell Längenkorrektur
  correction_.correct_positions(moment.state, pressed, book);
  correction_.correct_velocities(moment.state, pressed, book);

  moment.t += dt;
  ++book.cost.steps;
  arrive(moment, book);
}

void Stepper::observe(Moment& moment, Bookkeeping& book) {
  moment.resting.assign(moment.state.size(), 0);
  std::vector<Contact> contacts;
  finder_.find(*system_, moment.state, contacts);
  note_overlap(finder_.deepest().depth, finder_.deepest().scale, book.audit);
  std::set<ContactId> known;
  for (const Contact& c : contacts)
    known.insert(c.id());
  for (const Contact& c : moment.loaded) {
    if (known.insert(c.id()).second) contacts.push_back(at_poses(*system_, finder_.boxes(), c));
  }
  find_islands(*system_, contacts, moment.islands);
  moment.solutions.assign(moment.islands.size(), {});
}

/// Accelerations under the contacts that do not open, or that carry load between steps. There cubes
/// fit each other to the order of the step only, and the terms of their velocities may contradict
/// one another: without them the forces are those that carry the weights.
IslandSolution Stepper::accelerate_island(const std::set<ContactId>& loads,
                                          const Island& island,
                                          Moment& moment) {
  std::vector<SideUse> use;
  bool between_steps = false;
  for (const Contact& c : island.contacts) {
    const bool loaded = loads.contains(c.id());
    const bool opens = contact_motion(*system_, moment.state, c) == ContactMotion::opening;
    use.push_back(opens && !loaded ? SideUse::none : SideUse::inequality);
    between_steps = between_steps || loaded;
  }
  for (const int cube : island.cubes) {
    if (!between_steps) break;
    moment.felt[cube].velocity.setZero();
    moment.felt[cube].spin = 0.0;
  }
  return dynamics_.accelerations(moment.felt, island, use);
}

void Stepper::arrive(Moment& moment, Bookkeeping& book) {
  const Moment before = std::move(moment);
  moment = {};
  moment.t = before.t;
  moment.state = before.state;
  moment.resting = before.resting;
  moment.lasting = before.lasting;
  moment.resting.resize(system_->cubes, 0);
  std::vector<Contact> contacts;
  finder_.find(*system_, moment.state, contacts);
  note_overlap(finder_.deepest().depth, finder_.deepest().scale, book.audit);
  if (settings_.skips.islands) {
    find_islands(*system_, contacts, moment.islands);
    if (!settings_.skips.free_bodies) add_free_cubes(*system_, moment.islands);
  } else {
    one_island(*system_, contacts, moment.islands);
  }
  moment.solutions.resize(moment.islands.size());
  keep_rest(moment, before);
  for (const Island& island : moment.islands) {
    if (resting(moment, island)) continue;
    // (3) must hold where (2) = 0: an impact. The paper has no law for it; Moreau's projection is
    // ours.
    if (closes(*system_, moment.state, island)) strike(moment, island, book);
    settle(*system_, island, moment.state);
  }
  moment.lasting.clear();
  for (const Contact& c : contacts)
    moment.lasting.push_back(c.id());
  std::ranges::sort(moment.lasting);
}

/// Nothing has changed about an island since its rest was certified: the forces are the same, too.
void Stepper::keep_rest(Moment& moment, const Moment& before) const {
  std::size_t k = 0;
  for (std::size_t m = 0; m < moment.islands.size(); ++m) {
    const Island& island = moment.islands[m];
    if (!resting(moment, island)) continue;
    while (k < before.islands.size() && before.islands[k].cubes.front() < island.cubes.front())
      ++k;
    if (k == before.islands.size()) return;
    if (before.islands[k].cubes == island.cubes) moment.solutions[m] = before.solutions[k];
  }
}

void Stepper::strike(Moment& moment, const Island& island, Bookkeeping& book) {
  const auto [after, loss] = impact(*system_, moment.state, island, dynamics_);
  keep_book(after, book);
  set_velocities(island, after.twists, moment.state);
  book.audit.impact_loss += loss;
  const double least = after.least_pressing();
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const Contact& c = island.contacts[k];
    // A contact that lasts is struck in each step by the step's error; that is no event.
    if (after.forces[k] <= least || std::ranges::binary_search(moment.lasting, c.id())) continue;
    book.events.push_back({moment.t, EventKind::impact, system_->body(c.on).name,
                           system_->body(c.from).name, c.point, after.forces[k]});
  }
}

bool Stepper::resting(const Moment& moment, const Island& island) const {
  return std::ranges::all_of(island.cubes, [&](int cube) { return moment.resting[cube] != 0; });
}

void Stepper::accelerate(Moment& moment, Bookkeeping& book) {
  if (!moment.accelerations.empty()) return;
  moment.accelerations.assign(system_->cubes, {system_->gravity, 0.0});
  moment.felt = moment.state;
  std::set<ContactId> loads;
  for (const Contact& c : moment.loaded)
    loads.insert(c.id());
  book.cost.skipped_free += system_->cubes;
  for (std::size_t m = 0; m < moment.islands.size(); ++m) {
    const Island& island = moment.islands[m];
    IslandSolution& solution = moment.solutions[m];
    book.cost.skipped_free -= static_cast<long>(island.cubes.size());
    if (!solution.twists.empty()) {
      for (const int cube : island.cubes)
        moment.accelerations[cube] = {};
      ++book.cost.skipped_rest;
      continue;
    }
    solution = accelerate_island(loads, island, moment);
    keep_book(solution, book);
    const double g = system_->gravity.norm();
    const bool rests = settings_.skips.rest && is_still(island, moment.state)
                       && accelerations_vanish(*system_, island, solution, g);
    for (std::size_t k = 0; k < island.cubes.size(); ++k) {
      const auto cube = static_cast<std::size_t>(island.cubes[k]);
      moment.resting[cube] = rests ? 1 : 0;
      moment.accelerations[cube] = rests ? Twist{} : solution.twists[k];
    }
  }
}

std::vector<Contact> Stepper::pressed_contacts(const Moment& moment) const {
  std::vector<Contact> pressed;
  for (std::size_t m = 0; m < moment.islands.size(); ++m) {
    const Island& island = moment.islands[m];
    const IslandSolution& solution = moment.solutions[m];
    const double least = solution.least_pressing();
    for (std::size_t k = 0; k < island.contacts.size(); ++k) {
      if (solution.forces[k] > least) pressed.push_back(island.contacts[k]);
    }
  }
  return pressed;
}

/// Moreau and Jean: the velocity nearest to that of free flight which closes no contact, and a step
/// with it (theta = 1; Acary and Brogliato, "Numerical Methods for Nonsmooth Dynamical Systems",
/// 2008, chapter 10). Returns the contacts that were pressed.
std::vector<Contact> Stepper::sweep(Moment& moment, double dt, Bookkeeping& book) {
  // What stands still may be certified to rest.
  const bool still = std::ranges::all_of(
      moment.islands, [&](const Island& island) { return is_still(island, moment.state); });
  if (still) accelerate(moment, book);
  for (std::size_t i = 0; i < moment.state.size(); ++i) {
    if (moment.resting[i] == 0) moment.state[i].velocity += dt * system_->gravity;
  }
  std::vector<Contact> pressed;
  for (const Island& island : moment.islands) {
    if (resting(moment, island)) continue;
    const IslandSolution solution = dynamics_.impact(moment.state, island);
    keep_book(solution, book);
    set_velocities(island, solution.twists, moment.state);
    const double least = solution.least_pressing();
    for (std::size_t k = 0; k < island.contacts.size(); ++k) {
      if (solution.forces[k] > least) pressed.push_back(island.contacts[k]);
    }
  }
  for (std::size_t i = 0; i < moment.state.size(); ++i) {
    if (moment.resting[i] != 0) continue;
    moment.state[i].position += dt * moment.state[i].velocity;
    moment.state[i].angle += dt * moment.state[i].spin;
  }
  return pressed;
}

void Stepper::integrate(Moment& moment, double dt) const {
  const bool old_velocity = settings_.integrator == Integrator::euler;
  for (std::size_t i = 0; i < moment.state.size(); ++i) {
    if (moment.resting[i] != 0) continue;
    BodyState& s = moment.state[i];
    const Twist& a = moment.accelerations[i];
    if (settings_.formulation == Formulation::rigid) {
      const Twist before{s.velocity, s.spin};
      s.velocity += a.linear * dt;
      s.spin += a.angular * dt;
      s.position += (old_velocity ? before.linear : s.velocity) * dt;
      s.angle += (old_velocity ? before.angular : s.spin) * dt;
      continue;
    }
    // To the letter: every point moves by itself, and the rods are put right afterwards.
    const Body& body = system_->bodies[i];
    CubePoints points = points_of(s, body.size);
    for (std::size_t k = 0; k < points.p.size(); ++k) {
      const Vec2 r = points.p[k] - s.position;
      const Vec2 a_k = a.linear + a.angular * perp(r) - s.spin * s.spin * r;
      const Vec2 v_old = points.v[k];
      points.v[k] += a_k * dt;
      points.p[k] += (old_velocity ? v_old : points.v[k]) * dt;
    }
    s = nearest_cube(points, body.size, body.mass, s);
  }
}

}  // namespace wuerfel
