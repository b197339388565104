/// What every answer with friction must fulfil.
#pragma once

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/check.h"
#include "tests/support/stacks.h"

namespace wuerfel::test {

inline constexpr double tolerance = 1e-9;          // of g
inline constexpr double balance_tolerance = 1e-8;  // of the total weight

inline Check check_as(const Scene& scene, Formulation formulation = Formulation::rigid) {
  return check(scene, {.formulation = formulation});
}

inline const SceneCube* find_cube(const Scene& scene, const std::string& name) {
  const auto found = std::ranges::find(scene.cubes, name, &SceneCube::name);
  return found == scene.cubes.end() ? nullptr : &*found;
}

// Newton's law of every cube under the forces that are reported, from the JSON's contract alone.
inline void expect_balance(const Scene& scene, const Check& answer, double largest) {
  for (std::size_t i = 0; i < scene.cubes.size(); ++i) {
    const SceneCube& cube = scene.cubes[i];
    const double inertia = cube.mass * cube.size.squaredNorm() / 12.0;
    Vec2 force = cube.mass * (answer.accelerations[i].linear - scene.gravity);
    double torque = inertia * answer.accelerations[i].angular;
    for (const ContactForce& c : answer.contacts) {
      const double sign = c.on == cube.name ? 1.0 : c.from == cube.name ? -1.0 : 0.0;
      const Vec2 push = sign * (c.force * c.normal + c.tangential * perp(c.normal));
      const Vec2 r = c.point - cube.position;
      force -= push;
      torque -= det(r, push);
    }
    EXPECT_LE(force.norm(), balance_tolerance * largest) << cube.name;
    EXPECT_LE(std::abs(torque), balance_tolerance * largest) << cube.name;
  }
}

inline double mu_of(const Scene& scene, const std::string& name) {
  if (const SceneCube* c = find_cube(scene, name)) return c->material.friction;
  for (const ScenePlane& p : scene.planes)
    if (p.name == name) return p.material.friction;
  for (const SceneFixed& f : scene.fixed)
    if (f.name == name) return f.material.friction;
  ADD_FAILURE() << name;
  return 0.0;
}

inline void expect_cones(const Scene& scene, const Check& answer, double largest) {
  for (const ContactForce& c : answer.contacts) {
    const double mu = std::sqrt(mu_of(scene, c.on) * mu_of(scene, c.from));
    EXPECT_GE(c.force, 0.0);
    EXPECT_LE(std::abs(c.tangential), mu * c.force + 1e-9 * largest);
  }
}

inline double largest_force(const Scene& scene, const Check& answer) {
  double largest = 0.0;
  for (const SceneCube& c : scene.cubes)
    largest += c.mass * g;
  for (const ContactForce& c : answer.contacts)
    largest = std::max(largest, c.force);
  return largest;
}

}  // namespace wuerfel::test
