// The interior point method on Coulomb's law where its path folds.
#include "core/qp/coulomb/cone_interior_point.h"

#include <gtest/gtest.h>

#include "tests/support/friction_zoo.h"

namespace wuerfel::test {
namespace {

/// So many bodies in touch with random velocities.
ConeInteriorOutcome outcome_of_pile(int bodies, std::uint64_t seed, double mu, Folds folds) {
  FrictionOptions options{.mu = mu, .tumble = true};
  options.zoo.seed = seed;
  const FrictionCase c = friction_pile(bodies, options);
  CoulombJudge judge;
  const CoulombScales& scales = judge.measure_scales(c.program);
  ContactForm form;
  form.prepare(c.view(), scales);
  ConeInteriorPoint method;
  ContactPoint point;
  return method.run(form, scales.weight, {.goal = 1e-6, .folds = folds}, point);
}

TEST(ConeInteriorPoint, CrossesFoldsFromWhichItDoesNotComeBack) {
  for (const std::uint64_t seed : {2U, 3U}) {
    EXPECT_GT(outcome_of_pile(200, seed, 0.8, Folds::go_back).worst, 1e-3) << seed;
    const ConeInteriorOutcome crossed = outcome_of_pile(200, seed, 0.8, Folds::cross);
    EXPECT_LT(crossed.worst, 1e-6) << seed;
  }
  const ConeInteriorOutcome small = outcome_of_pile(100, 5, 0.8, Folds::cross);
  EXPECT_LT(small.worst, 1e-6);
  EXPECT_LT(small.factorisations, 100);
}

TEST(ConeInteriorPoint, TakesTheSameStepsWhereThePathDoesNotFold) {
  const ConeInteriorOutcome back = outcome_of_pile(100, 7, 0.6, Folds::go_back);
  const ConeInteriorOutcome across = outcome_of_pile(100, 7, 0.6, Folds::cross);
  EXPECT_LT(back.worst, 1e-6);
  EXPECT_EQ(back.worst, across.worst);
  EXPECT_EQ(back.factorisations, across.factorisations);
}

}  // namespace
}  // namespace wuerfel::test
