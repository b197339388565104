// What every run promises, and who broke it first.
#include "core/time/promises.h"

#include <gtest/gtest.h>

#include "core/dynamics/momentum_balance.h"

namespace wuerfel::test {
namespace {

TEST(Promises, MomentaChangeByWhatActsOnThem) {
  Audit audit;
  audit.momentum_linear = audit.momentum_angular = 1.1e-4;
  EXPECT_TRUE(broken_promises(audit).empty()) << "nothing is promised yet";
  audit.momentum_budget = promised_momentum_of_steps;
  audit.settled_budget = promised_settled_of_steps;
  EXPECT_EQ(broken_promises(audit), std::vector{Promise::momentum});
  audit.momentum_linear = 0.9e-4;
  EXPECT_EQ(broken_promises(audit), std::vector{Promise::momentum}) << "the angular one";
  audit.momentum_angular = 0.9e-4;
  EXPECT_TRUE(broken_promises(audit).empty());
}

TEST(Promises, WhatStepsSettleHasABudgetOfItsOwn) {
  Audit audit;
  audit.momentum_budget = promised_momentum_of_steps;
  audit.settled_budget = promised_settled_of_steps;
  audit.momentum_settled = 1.1 * promised_settled_of_steps;
  EXPECT_EQ(broken_promises(audit), std::vector{Promise::momentum});
  audit.momentum_settled = 0.9 * promised_settled_of_steps;
  EXPECT_TRUE(broken_promises(audit).empty());
}

TEST(Promises, TheGravestIsTheFirst) {
  Audit audit;
  audit.max_overlap = 2e-9;
  audit.missed_solves = 1;
  audit.max_rod_error = 2e-9;
  EXPECT_EQ(broken_promises(audit),
            (std::vector{Promise::programs, Promise::rods, Promise::overlap}));
}

TEST(Promises, EnergyMayDriftByItsBudgetEitherWay) {
  for (const double drift : {0.2, -0.2}) {
    Audit audit;
    audit.energy_start = 5.0;
    audit.energy_end = 4.0 + drift;
    audit.impact_loss = 1.0;
    EXPECT_TRUE(broken_promises(audit).empty()) << "nothing is promised";
    audit.drift_budget = 0.1;
    EXPECT_EQ(broken_promises(audit), std::vector{Promise::energy});
    audit.drift_budget = 0.3;
    EXPECT_TRUE(broken_promises(audit).empty());
  }
}

TEST(Promises, AreBrokenByThoseWhoBrokeThemFirst) {
  Bookkeeping book;
  Audit before;
  before.unresolved = 1;
  book.audit = before;
  book.audit.max_overlap = 1e-6;
  const std::vector<std::string> names = {"a", "b"};
  note_breaches(before, 2.0, names, book);
  ASSERT_EQ(book.breaches.size(), 1U) << "events were broken before";
  EXPECT_EQ(book.breaches[0].promise, Promise::overlap);
  EXPECT_EQ(book.breaches[0].t, 2.0);
  EXPECT_EQ(book.breaches[0].bodies, names);
  book.breaches.push_back({Promise::overlap, 1.0, {"c"}});
  book.breaches.push_back({Promise::events, 0.5, {"d"}});
  EXPECT_EQ(first_breach(book.breaches, Promise::overlap)->bodies, std::vector<std::string>{"c"});
  EXPECT_EQ(first_breach(book.breaches, Promise::rods), nullptr);
}

}  // namespace
}  // namespace wuerfel::test
