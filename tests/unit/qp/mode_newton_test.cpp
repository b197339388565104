// Newton's method from known modes, and the way to the edges of cones.
#include "core/qp/coulomb/mode_newton.h"

#include <gtest/gtest.h>

#include "core/qp/coulomb/coulomb_residual.h"
#include "tests/support/friction_zoo.h"
#include "tests/support/laid_bricks.h"

namespace wuerfel {
namespace {

using test::FrictionBuilder;
using test::FrictionCase;

/// A box that falls at 1 m/s on three points of the floor; `bump` is by how much the one in the middle is too high.
///
///     +-----------+
///     |           |
///     +-----------+
///     ^     ^     ^
FrictionCase box_on_three_points(double bump) {
  FrictionBuilder builder({.mu = 0.5});
  builder.add_body(0.0, 0.5, 2.0, 1.0);
  for (const double x : {-1.0, 0.0, 1.0})
    builder.add_contact(0, test::ground, x, 0.0, 0.0, 1.0);
  FrictionCase c = builder.take();
  c.program.target = {0.0, -1.0, 0.0};
  c.program.bound[c.contacts[1].normal] = bump;
  return c;
}

struct Found {
  ModeNewtonOutcome outcome;
  ContactPoint point;
  double missed = 0.0;
};

Found found_from_sticking(const FrictionCase& c) {
  CoulombJudge judge;
  ContactForm form;
  form.prepare(c.view(), judge.measure_scales(c.program));
  std::vector<ContactMode> modes(c.contacts.size(), ContactMode::stick);
  Found found;
  found.point.reset(form);
  ModeNewton newton;
  found.outcome = newton.run(form, modes, found.point, {});
  found.missed = missed_by(form, modes, found.point);
  return found;
}

TEST(ModeNewton, FindsAPieceByOneFactorisation) {
  const Found found = found_from_sticking(box_on_three_points(0.0));
  EXPECT_TRUE(found.outcome.settled);
  EXPECT_EQ(found.outcome.factorisations, 1);
  EXPECT_NEAR(found.point.l[0].n, found.point.l[2].n, 1e-12);
}

// The three rows contradict one another by the bump: forces go from the corners to the middle for ever, in steps of the bump
// over the compliance, until a corner is free.
TEST(ModeNewton, LeapsToWhereAContactGivesWay) {
  for (const double bump : {1e-9, 1e-10, 1e-11}) {
    const FrictionCase c = box_on_three_points(bump);
    const Found found = found_from_sticking(c);
    EXPECT_TRUE(found.outcome.settled) << bump;
    EXPECT_LE(found.missed, 1e-12) << bump;
    EXPECT_NEAR(found.point.l[1].n, c.program.mass[1], 1e-8) << bump;
  }
}

TEST(Crossing, MeetsTheEdgeOfTheConeThatComesFirst) {
  ContactUnit unit;
  unit.mu = 0.5;
  Crossing first;
  first.meet_cone(unit, ContactMode::stick, {2.0, 0.0}, {-1.0, 0.5}, 3);
  EXPECT_DOUBLE_EQ(first.step, 1.0);  // 0.5 (2 - s) = 0.5 s
  EXPECT_EQ(first.unit, 3);
  EXPECT_EQ(first.to, ContactMode::slip_back);
  first.meet_cone(unit, ContactMode::slip_forward, {1.0, -0.5}, {-2.0, 1.0}, 5);
  EXPECT_DOUBLE_EQ(first.step, 0.5);
  EXPECT_EQ(first.unit, 5);
  EXPECT_EQ(first.to, ContactMode::open);
  first.meet_cone(unit, ContactMode::stick, {1.0, 0.0}, {1.0, 0.1}, 7);
  EXPECT_EQ(first.unit, 5) << "what grows into its cone meets no edge";
}

}  // namespace
}  // namespace wuerfel
