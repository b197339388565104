/// Stands or falls: the answer of one Gauss program, without simulating.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/model/state.h"
#include "core/scene/scene.h"
#include "core/settings.h"

namespace wuerfel {

enum class Verdict { stands, falls, moves, undecided };
std::string_view to_string(Verdict verdict);

struct ContactForce {
  std::string on;  ///< the body that `normal` points into
  std::string from;
  Vec2 point = Vec2::Zero();    ///< m
  Vec2 normal = Vec2::UnitY();  ///< unit vector into `on`
  double force = 0.0;           ///< N, >= 0, acts on `on` along `normal`
  double tangential = 0.0;      ///< N, along `normal` turned left
  bool unique = true;           ///< whether no other force at this point is possible
};

struct Check {
  Verdict verdict = Verdict::undecided;
  std::vector<Twist> accelerations;    ///< m/s^2 and rad/s^2, in the order of Scene::cubes
  std::vector<ContactForce> contacts;  ///< each contact once
  double objective = 0.0;              ///< sum m |a-g|^2 + I alpha^2
  double kkt_residual = 0.0;
};

/// Throws SceneError where bodies overlap.
Check check(const Scene& scene, const MotionSettings& settings);

}  // namespace wuerfel
