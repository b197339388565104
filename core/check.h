/// Stands or falls: the answer of one Gauss program, without simulating.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/dynamics/verdict.h"
#include "core/model/state.h"
#include "core/scene/scene.h"
#include "core/settings.h"

namespace wuerfel {

struct ContactForce {
  std::string on;  ///< the body that `normal` points into
  std::string from;
  Vec2 point = Vec2::Zero();    ///< m
  Vec2 normal = Vec2::UnitY();  ///< unit vector into `on`
  double force = 0.0;           ///< N, >= 0, acts on `on` along `normal`
  double tangential = 0.0;      ///< N, along `normal` turned left
  /// Whether no other `force` is possible here, and no other `tangential` but for a share of it that flush sides
  /// can pass to each other's corners.
  bool unique = true;
};

struct RodForce {
  std::string name;
  double force = 0.0;  ///< N, tension positive
  bool unique = true;  ///< whether no other force of this rod is possible
};

struct PinForce {
  std::string name;
  Vec2 force = Vec2::Zero();  ///< N, on the body of `from`
  bool unique = true;
};

/// Three facts apart, of a scene in which any pair rubs; all false where something moves.
struct FrictionFacts {
  bool equilibrium_exists = false;       ///< admissible forces balance all weights
  bool stands_without_friction = false;  ///< it needs no friction for that
  bool fall_also_possible = false;       ///< the law has a solution that falls as well
};

struct Check {
  Verdict verdict = Verdict::undecided;
  std::vector<Twist> accelerations;    ///< m/s^2 and rad/s^2, of cubes, then points (moving_name)
  std::vector<ContactForce> contacts;  ///< each contact once
  std::vector<RodForce> rods;          ///< in the order of the scene
  std::vector<PinForce> pins;
  double objective = 0.0;  ///< sum m |a-g|^2 + I alpha^2
  double kkt_residual = 0.0;
  std::optional<FrictionFacts> facts;
  /// Where cubes that rub cannot stay at rest: a virtual motion (m/s^2 and rad/s^2, as
  /// `accelerations`, which it is not) along which no admissible force can hold their weights.
  std::vector<Twist> certificate;
  bool jams = false;  ///< no acceleration satisfies Coulomb's law at the start [Painlevé 1895]
};

/// Throws SceneError where bodies overlap.
Check check(const Scene& scene, const MotionSettings& settings);

}  // namespace wuerfel
