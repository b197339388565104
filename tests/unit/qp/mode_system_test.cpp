// The linear system of a piece of Coulomb's law, when contacts change their modes.
#include <gtest/gtest.h>

#include "core/qp/coulomb/contact_modes.h"
#include "tests/support/friction_zoo.h"

namespace wuerfel::test {
namespace {

constexpr double delta = 1e-6;

/// A wall of 65 bodies, all of whose contacts slip, and right-hand sides.
struct Wall {
  Wall() {
    CoulombJudge judge;
    const FrictionCase c = friction_wall(8, 8, {.mu = 0.6, .spin = 1.0});
    form.prepare(c.view(), judge.measure_scales(c.program));
    modes.assign(form.count(), ContactMode::slip_forward);
    Dice dice(5);
    for (const ContactUnit& unit : form.units()) {
      r.push_back({dice.uniform(-1.0, 1.0) / unit.per_velocity.n,
                   dice.uniform(-1.0, 1.0) / unit.per_velocity.t});
    }
    u.assign(form.blocks(), Quad{});
  }
  /// Solved with factors of its own.
  [[nodiscard]] std::vector<Pair> solved_anew() {
    ModeSystem fresh;
    EXPECT_TRUE(fresh.factorise(form, modes, delta, Pivoting::none));
    fresh.solve(form, r, u);
    return fresh.Gdy();
  }

  ContactForm form;
  std::vector<ContactMode> modes;
  std::vector<Pair> r;
  std::vector<Quad> u;
};

double largest_difference(const std::vector<Pair>& a, const std::vector<Pair>& b) {
  double size = 0.0;
  double difference = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    size = std::max({size, std::abs(a[i].n), std::abs(a[i].t)});
    difference = std::max({difference, std::abs(a[i].n - b[i].n), std::abs(a[i].t - b[i].t)});
  }
  return difference / size;
}

TEST(ModeSystem, SolvesOnAsContactsChangeWithTheFactorsItHas) {
  Wall wall;
  ASSERT_GT(wall.form.blocks(), 60);
  ModeSystem system;
  ASSERT_TRUE(system.factorise(wall.form, wall.modes, delta, Pivoting::none));
  system.solve(wall.form, wall.r, wall.u);
  const std::vector changes = {ContactMode::stick, ContactMode::slip_back, ContactMode::open,
                               ContactMode::slip_forward};
  for (int k = 0; k < 20; ++k) {
    const int unit = 7 * (k / 4);
    wall.modes[unit] = changes[k % 4];
    ASSERT_TRUE(system.change(wall.form, wall.modes, unit));
    ASSERT_TRUE(system.updated()) << k;
    system.solve_again(wall.form, wall.r, wall.u, unit);
    // A copy: the form keeps one set of factors.
    Wall other = wall;
    EXPECT_LT(largest_difference(system.Gdy(), other.solved_anew()), 1e-9) << k;
  }
}

TEST(ModeSystem, FactorisesAnewWhereThatIsCheaperOrNeeded) {
  Wall wall;
  ModeSystem system;
  ASSERT_TRUE(system.factorise(wall.form, wall.modes, delta, Pivoting::none));
  wall.modes[3] = ContactMode::open;
  ASSERT_TRUE(system.change(wall.form, wall.modes, 3));
  EXPECT_TRUE(system.updated());
  wall.modes[3] = ContactMode::stick;  // of rank two
  ASSERT_TRUE(system.change(wall.form, wall.modes, 3));
  EXPECT_FALSE(system.updated());
  int updates = 0;
  do {
    const int unit = updates % wall.form.count();
    wall.modes[unit] = wall.modes[unit] == ContactMode::slip_back ? ContactMode::slip_forward
                                                                  : ContactMode::slip_back;
    ASSERT_TRUE(system.change(wall.form, wall.modes, unit));
    ++updates;
  } while (system.updated());
  EXPECT_GT(updates, 20);
  system.solve(wall.form, wall.r, wall.u);
  EXPECT_LT(largest_difference(system.Gdy(), wall.solved_anew()), 1e-12);
}

}  // namespace
}  // namespace wuerfel::test
