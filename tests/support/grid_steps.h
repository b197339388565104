/// One step of a reference method, of 0.125 s.
#pragma once

#include <gtest/gtest.h>

#include "core/time/reference/active_restrictions.h"
#include "core/time/reference/algorithm_1.h"
#include "core/time/reference/moreau.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {

inline constexpr double dt = 0.125;
inline constexpr double rounding = 1e-15;

inline BodyState one_step(const Scene& scene,
                          Integrator integrator,
                          Formulation formulation,
                          Bookkeeping& book) {
  const System system = make_system(scene);
  Workspace work(system, {.formulation = formulation});
  GridPoint point;
  point.state = initial_state(scene);
  find_restrictions(point, work, book);
  if (integrator == Integrator::moreau) {
    step_by_moreau(point, dt, work, book);
  } else {
    step_by_algorithm_1(point, dt, integrator == Integrator::euler, work, book);
  }
  EXPECT_EQ(point.t, dt);
  return point.state[0];
}

/// A turning cube in flight.
inline Scene turning_flight() {
  Scene scene;
  scene.cubes = {cube("a", {1.0, 10.0}, 0.25, 2.0)};
  scene.cubes[0].velocity = {3.0, 1.0};
  return scene;
}

}  // namespace wuerfel::test
