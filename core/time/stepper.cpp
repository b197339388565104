#include "core/time/stepper.h"

#include <algorithm>
#include <cmath>

#include "core/model/points.h"

namespace wuerfel {
namespace {

/// Rest is certified where the acceleration is below this share of g (design, "Verdict").
constexpr double rest_acceleration = 1e-10;

/// A contact carries load where its force exceeds this share of the island's largest.
constexpr double pressed_share = 1e-9;

/// Gaps are corrected to this share of the smaller side: well inside touching_tolerance, well above
/// rounding.
constexpr double corrected_gap = 1e-11;
/// Rounds of corrections: sides stay closed in the first ones; where that does not settle, only
/// overlap is removed.
constexpr int closing_corrections = 12;
constexpr int most_corrections = 40;

void keep_book(const IslandSolution& solution, Bookkeeping& book) {
  ++(solution.skipped ? book.cost.skipped_certificate : book.cost.qp_solves);
  book.audit.max_kkt_residual = std::max(book.audit.max_kkt_residual, solution.residual);
  if (solution.status != QpStatus::optimal) ++book.audit.missed_solves;
}

void set_velocities(const Island& island, const std::vector<Twist>& velocities, State& state) {
  for (std::size_t k = 0; k < island.cubes.size(); ++k) {
    BodyState& s = state[static_cast<std::size_t>(island.cubes[k])];
    s.velocity = velocities[k].linear;
    s.spin = velocities[k].angular;
  }
}

void displace(const Island& island, const std::vector<Twist>& displacements, State& state) {
  for (std::size_t k = 0; k < island.cubes.size(); ++k) {
    BodyState& s = state[static_cast<std::size_t>(island.cubes[k])];
    s.position += displacements[k].linear;
    s.angle += displacements[k].angular;
  }
}

/// Velocities that count as zero become zero, so that rest can be certified.
void settle(const System& system, const Island& island, State& state) {
  for (const int cube : island.cubes) {
    const BodyState& s = state[static_cast<std::size_t>(cube)];
    const double side = system.body(cube).size.minCoeff();
    const double zero = rate_tolerance * std::sqrt(system.gravity.norm() * side);
    if (s.velocity.norm() + side * std::abs(s.spin) > zero) return;
  }
  for (const int cube : island.cubes) {
    state[static_cast<std::size_t>(cube)].velocity.setZero();
    state[static_cast<std::size_t>(cube)].spin = 0.0;
  }
}

bool contains(const std::vector<Contact>& contacts, const Contact& c) {
  return std::ranges::any_of(contacts, [&](const Contact& d) { return d.id() == c.id(); });
}

bool is_still(const Island& island, const State& state) {
  return std::ranges::all_of(island.cubes, [&](int cube) {
    const BodyState& s = state[static_cast<std::size_t>(cube)];
    return s.velocity.isZero(0.0) && s.spin == 0.0;
  });
}

}  // namespace

Stepper::Stepper(const System& system, const MotionSettings& settings)
    : system_(&system), settings_(settings), dynamics_(system, settings) {}

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
  accelerate(moment, book);
  const std::vector<Contact> pressed = pressed_contacts(moment);

  // v := v + a dt,  p := p + v dt
  integrate(moment, dt);

  // Eventuell Längenkorrektur
  correct_positions(moment.state, pressed, book);
  correct_velocities(moment.state, pressed, book);

  moment.t += dt;
  ++book.cost.steps;
  arrive(moment, book);
}

void Stepper::observe(Moment& moment, Bookkeeping& book) {
  moment.resting.assign(moment.state.size(), 0);
  std::vector<Contact> contacts;
  finder_.find(*system_, moment.state, contacts);
  book.audit.max_penetration = std::max(book.audit.max_penetration, finder_.deepest().depth);
  find_islands(*system_, contacts, moment.islands);
  moment.solutions.assign(moment.islands.size(), {});
}

void Stepper::arrive(Moment& moment, Bookkeeping& book) {
  const Moment before = std::move(moment);
  moment = {};
  moment.t = before.t;
  moment.state = before.state;
  moment.resting = before.resting;
  moment.lasting = before.lasting;
  moment.resting.resize(static_cast<std::size_t>(system_->cubes), 0);
  std::vector<Contact> contacts;
  finder_.find(*system_, moment.state, contacts);
  book.audit.max_penetration = std::max(book.audit.max_penetration, finder_.deepest().depth);
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
    const bool closing = std::ranges::any_of(island.contacts, [&](const Contact& c) {
      return contact_motion(*system_, moment.state, c) == ContactMotion::closing;
    });
    // (3) must hold where (2) = 0: an impact. The paper has no law for it; Moreau's projection is
    // ours.
    if (closing) strike(moment, island, book);
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
  const double before = kinetic_energy(*system_, moment.state);
  const IslandSolution after = dynamics_.impact(moment.state, island);
  keep_book(after, book);
  set_velocities(island, after.twists, moment.state);
  book.audit.impact_loss += before - kinetic_energy(*system_, moment.state);
  const double largest = std::ranges::max(after.forces);
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const Contact& c = island.contacts[k];
    // A contact that lasts is struck in each step by the step's error; that is no event.
    if (after.forces[k] <= pressed_share * largest
        || std::ranges::binary_search(moment.lasting, c.id()))
      continue;
    book.events.push_back({moment.t, EventKind::impact, system_->body(c.on).name,
                           system_->body(c.from).name, c.point, after.forces[k]});
  }
}

bool Stepper::resting(const Moment& moment, const Island& island) const {
  return std::ranges::all_of(
      island.cubes, [&](int cube) { return moment.resting[static_cast<std::size_t>(cube)] != 0; });
}

void Stepper::accelerate(Moment& moment, Bookkeeping& book) {
  if (!moment.accelerations.empty()) return;
  moment.accelerations.assign(static_cast<std::size_t>(system_->cubes), {system_->gravity, 0.0});
  book.cost.skipped_free += system_->cubes;
  for (std::size_t m = 0; m < moment.islands.size(); ++m) {
    const Island& island = moment.islands[m];
    IslandSolution& solution = moment.solutions[m];
    book.cost.skipped_free -= static_cast<long>(island.cubes.size());
    if (!solution.twists.empty()) {
      for (const int cube : island.cubes)
        moment.accelerations[static_cast<std::size_t>(cube)] = {};
      ++book.cost.skipped_rest;
      continue;
    }
    solution = dynamics_.accelerations(moment.state, island);
    keep_book(solution, book);
    const double limit = rest_acceleration * system_->gravity.norm();
    const bool rests = settings_.skips.rest && solution.status == QpStatus::optimal
                       && is_still(island, moment.state)
                       && largest_acceleration(*system_, island, solution.twists) <= limit;
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
    if (island.contacts.empty()) continue;
    const double largest = std::ranges::max(solution.forces);
    for (std::size_t k = 0; k < island.contacts.size(); ++k) {
      if (solution.forces[k] > pressed_share * largest) pressed.push_back(island.contacts[k]);
    }
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

void Stepper::correct_positions(State& state, std::vector<Contact> closed, Bookkeeping& book) {
  std::vector<Contact> contacts;
  std::vector<Island> islands;
  for (int round = 0; round < most_corrections; ++round) {
    finder_.find(*system_, state, contacts);
    if (round >= closing_corrections) closed.clear();
    // A side that was pressed stays closed, unless the corner has left its end.
    std::erase_if(closed, [&](Contact& c) {
      c = at_poses(*system_, finder_.boxes(), c);
      return c.alpha < 0.0 || c.alpha > 1.0;
    });
    for (const Contact& c : closed) {
      if (!contains(contacts, c)) contacts.push_back(c);
    }
    find_islands(*system_, contacts, islands);
    bool corrected = false;
    for (const Island& island : islands) {
      corrected = correct_island(island, state, closed, book) || corrected;
    }
    if (!corrected) return;
  }
}

bool Stepper::correct_island(const Island& island,
                             State& state,
                             std::vector<Contact>& closed,
                             Bookkeeping& book) {
  std::vector<SideUse> use;
  bool off = false;
  for (const Contact& c : island.contacts) {
    const bool keep = contains(closed, c);
    use.push_back(keep ? SideUse::equality : SideUse::inequality);
    off = off || (keep ? std::abs(c.gap) : -c.gap) > corrected_gap * contact_scale(*system_, c);
  }
  if (!off) return false;
  IslandSolution solution = dynamics_.correction(state, island, use);
  if (solution.status != QpStatus::optimal) {
    // Closed sides contradict one another by the step's error: then only overlap is removed.
    std::erase_if(closed, [&](const Contact& c) { return contains(island.contacts, c); });
    std::ranges::fill(use, SideUse::inequality);
    solution = dynamics_.correction(state, island, use);
  }
  keep_book(solution, book);
  displace(island, solution.twists, state);
  // What was pushed out of an overlap ends closed, not open by the second order of the
  // displacement: else the next moment would not see it touch.
  for (std::size_t k = 0; k < use.size(); ++k) {
    if (use[k] == SideUse::inequality && solution.forces[k] > 0.0 && island.contacts[k].gap < 0.0) {
      closed.push_back(island.contacts[k]);
    }
  }
  return true;
}

void Stepper::correct_velocities(State& state,
                                 const std::vector<Contact>& pressed,
                                 Bookkeeping& book) {
  std::vector<Island> islands;
  find_islands(*system_, pressed, islands);
  for (const Island& island : islands) {
    const bool still = std::ranges::all_of(island.contacts, [&](const Contact& c) {
      return contact_motion(*system_, state, c) == ContactMotion::resting;
    });
    if (still) continue;
    const IslandSolution solution = dynamics_.tangential_velocities(state, island);
    keep_book(solution, book);
    set_velocities(island, solution.twists, state);
  }
}

}  // namespace wuerfel
