/// Forces and slacks of the interior point method on Coulomb's law (cone_interior_point.h), and steps of them.
#pragma once

#include <vector>

#include "core/qp/coulomb/contact_modes.h"

namespace wuerfel {

/// The three pairs of a unit: forces, what they are complementary to, targets' weights. Pairs that a
/// unit does not have stay (1, 0).
struct ConePairs {
  double force[3] = {1.0, 1.0, 1.0};
  double slack[3] = {0.0, 0.0, 0.0};
  double weight[3] = {1.0, 1.0, 1.0};
  int count = 0;
};
struct ConePairsStep {
  double force[3] = {0.0, 0.0, 0.0};
  double slack[3] = {0.0, 0.0, 0.0};
};

struct ConeIterate {
  std::vector<ConePairs> pairs;
  ContactPoint point;
};
struct ConeDirection {
  std::vector<ConePairsStep> pairs;
  ContactStep point;
};
/// Of force times slack over weight, after so much of the step.
double mean_product(const ConeIterate& at, const ConeDirection& step, double length);

/// How far a step goes, so that all forces and slacks stay above zero.
double step_length(const ConeIterate& at, const ConeDirection& step);
/// So that those of all units but a few do.
double step_length_of_most(const ConeIterate& at, const ConeDirection& step);

/// A unit that would leave its cone stops short of its edge, with slacks as large as the others' products ask for, that it
/// may leave again. What that unbalances is part of the next right-hand side.
void move(double length, const ConeDirection& step, ConeIterate& at);

}  // namespace wuerfel
