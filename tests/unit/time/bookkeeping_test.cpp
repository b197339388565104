// What is booked of programs, overlap and parts of a motion.
#include "core/time/bookkeeping.h"

#include <gtest/gtest.h>

#include "core/dynamics/solves.h"
#include "core/time/promises.h"

namespace wuerfel::test {
namespace {

IslandSolution solution(QpStatus status, double residual) {
  IslandSolution s;
  s.status = status;
  s.residual = residual;
  s.iterations = 3;
  return s;
}

TEST(Solves, TellAnswersFromThoseThatAreNone) {
  Solves solves;
  solves.add(solution(QpStatus::optimal, 1e-12));
  solves.add(solution(QpStatus::inaccurate, 1e-6));
  solves.add(solution(QpStatus::infeasible, 1.0));
  EXPECT_EQ(solves.solved, 3);
  EXPECT_EQ(solves.iterations, 9);
  EXPECT_EQ(solves.missed, 1);
  EXPECT_EQ(solves.infeasible, 1);
  EXPECT_EQ(solves.residual, 1e-6);
}

TEST(Solves, AProgramWithoutAnAnswerHasNoResidual) {
  Solves solves;
  solves.add(solution(QpStatus::invalid, 0.0));
  EXPECT_EQ(solves.missed, 1);
  EXPECT_EQ(solves.residual, unbounded);
}

TEST(Solves, FrictionThatWasMissedIsNoResidualOfGauss) {
  IslandSolution s = solution(QpStatus::inaccurate, 1e-5);
  s.friction_inexact = true;
  Solves solves;
  solves.add(s);
  EXPECT_EQ(solves.friction_inexact, 1);
  EXPECT_EQ(solves.friction_residual, 1e-5);
  EXPECT_EQ(solves.residual, 0.0);
  EXPECT_EQ(solves.missed, 0);
}

TEST(Bookkeeping, CostAloneLeavesTheAudit) {
  Solves solves;
  solves.add(solution(QpStatus::inaccurate, 1e-5));
  Bookkeeping cost;
  keep_cost(solves, cost);
  EXPECT_EQ(cost.cost.qp_solves, 1);
  EXPECT_EQ(cost.cost.qp_iterations, 3);
  EXPECT_EQ(cost.audit.max_kkt_residual, 0.0);
  Bookkeeping all;
  keep_book(solves, all);
  EXPECT_EQ(all.cost.qp_solves, 1);
  EXPECT_EQ(all.audit.max_kkt_residual, 1e-5);
  EXPECT_EQ(all.audit.missed_solves, 1);
}

TEST(Bookkeeping, PartsAddUpAndTheWorstCounts) {
  Bookkeeping a;
  a.cost.steps = 2;
  note_overlap(1e-10, 0.5, a.audit);
  Bookkeeping b;
  b.cost.steps = 3;
  b.cost.skipped_rest = 1;
  note_overlap(2e-10, 2.0, b.audit);
  b.events.push_back({1.0, EventKind::touch, "a", "b", Vec2::Zero(), 0.0});
  add(b, a);
  EXPECT_EQ(a.cost.steps, 5);
  EXPECT_EQ(a.cost.qp_skipped(), 1);
  EXPECT_EQ(a.events.size(), 1U);
  EXPECT_EQ(a.audit.max_penetration, 2e-10);
  EXPECT_EQ(a.audit.max_overlap, 2e-10);
}

}  // namespace
}  // namespace wuerfel::test
