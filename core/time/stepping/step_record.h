/// What happened within a step of time stepping: from it states between its ends are read.
#pragma once

#include <vector>

#include "core/geometry/vec2.h"

namespace wuerfel {

/// The impulses of a contact in a step, both halves together. Acts in the course of the shares begin .. end of the
/// step, at once where these are equal.
struct StepImpulse {
  int on = 0;
  int from = 0;
  Vec2 linear = Vec2::Zero();  ///< N s, on `on`; its opposite on `from`
  double turn_on = 0.0;        ///< N m s, about the centre of `on`
  double turn_from = 0.0;      ///< N m s, about the centre of `from`
  double begin = 0.0;
  double end = 1.0;
};

/// Energy taken in the course of the shares begin .. end of a step, at once where these are equal.
struct StepLoss {
  double begin = 1.0;
  double end = 1.0;
  double energy = 0.0;  ///< J
  bool friction = false;
  /// What of it is taken by a share of the step.
  [[nodiscard]] double by(double share) const {
    if (share >= end) return energy;
    return share > begin ? (share - begin) / (end - begin) * energy : 0.0;
  }
};

/// Cubes that pushed one another, or something fixed.
struct StepComponent {
  std::vector<int> cubes;        ///< ascending
  std::vector<Vec2> held_along;  ///< directions in which fixed bodies that they touched hold them
  std::vector<StepLoss> losses;
};

struct StepRecord {
  std::vector<StepImpulse> impulses;
  std::vector<StepComponent> components;  ///< cubes in none of them flew freely
};

}  // namespace wuerfel
