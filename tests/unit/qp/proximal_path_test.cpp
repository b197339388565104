// Proximal steps along piecewise linear paths, from points at which Newton's method goes round in circles.
#include "core/qp/coulomb/proximal_path.h"

#include <gtest/gtest.h>

#include "core/qp/coulomb/cone_interior_point.h"
#include "tests/support/friction_zoo.h"

namespace wuerfel::test {
namespace {

/// Bodies in touch with random velocities, and the best point of an interior point method that does not arrive.
struct Pile {
  explicit Pile(std::uint64_t seed, double mu) {
    FrictionOptions options{.mu = mu, .tumble = true};
    options.zoo.seed = seed;
    program = friction_pile(100, options);
    CoulombJudge judge;
    const CoulombScales scales = judge.measure_scales(program.program);
    form.prepare(program.view(), scales);
    ConeInteriorPoint method;
    const ConeInteriorOutcome outcome =
        method.run(form, scales.weight, {.goal = 1e-6, .folds = Folds::cross}, point);
    EXPECT_GT(outcome.worst, 1e-4);
    for (int i = 0; i < form.count(); ++i)
      modes.push_back(mode_of(form.units()[i], point.l[i]));
  }
  static ContactMode mode_of(const ContactUnit& unit, const Pair& l) {
    if (l.n <= 0.0) return ContactMode::open;
    const bool slips = std::abs(l.t) > (1.0 - 1e-9) * unit.mu * l.n;
    return slips ? slip_mode(-l.t) : ContactMode::stick;
  }
  [[nodiscard]] double residual() const {
    std::vector<double> x;
    std::vector<double> multiplier;
    std::vector<Pair> forces = point.l;
    for (int i = 0; i < form.count(); ++i)
      clamp_to_cone(form.units()[i], forces[i]);
    form.read(program.program, point.y, x);
    form.read(forces, multiplier);
    return coulomb_residual(program.view(), x, multiplier).worst();
  }

  FrictionCase program;
  ContactForm form;
  std::vector<ContactMode> modes;
  ContactPoint point;
};

TEST(ProximalPath, ComesToTheLawFromAfar) {
  for (const std::uint64_t seed : {4U, 7U}) {
    Pile pile(seed, 2.0);
    ProximalPath path;
    path.begin(pile.point, {.delta = 1e-2, .most_crossings = 3000});
    EXPECT_GT(pile.residual(), 1e-4) << seed;
    while (pile.residual() > 1e-10)
      ASSERT_TRUE(path.step(pile.form, pile.modes, pile.point)) << seed;
    EXPECT_LE(path.crossings(), 3000) << seed;
  }
}

TEST(ProximalPath, EveryStepSatisfiesTheLawOfItsCompliance) {
  // Forces within their cones, and rows that are open nowhere closed: all that is missed are rows in force.
  Pile pile(4, 2.0);
  ProximalPath path;
  path.begin(pile.point, {.delta = 1e-2, .most_crossings = 3000});
  for (int k = 0; k < 5; ++k) {
    ASSERT_TRUE(path.step(pile.form, pile.modes, pile.point));
    EXPECT_NEAR(pile.residual() / missed_by(pile.form, pile.modes, pile.point), 1.0, 1e-6) << k;
  }
}

TEST(ProximalPath, LeavesThePointWhereItsEffortIsSpent) {
  Pile pile(4, 2.0);
  const std::vector<ContactMode> modes = pile.modes;
  const double residual = pile.residual();
  ProximalPath path;
  path.begin(pile.point, {.delta = 1e-2, .most_crossings = 0});
  EXPECT_FALSE(path.step(pile.form, pile.modes, pile.point));
  EXPECT_EQ(pile.modes, modes);
  EXPECT_EQ(pile.residual(), residual);
}

}  // namespace
}  // namespace wuerfel::test
