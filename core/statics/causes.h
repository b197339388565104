/// Why a scene falls: the motion that proves it, the parts that fail by themselves, and the mechanism
/// where none does.
#pragma once

#include <optional>
#include <vector>

#include "core/statics/parts.h"
#include "core/statics/still_scene.h"

namespace wuerfel {

/// Along this motion no contact closes, and the weights do work: no forces hold them [Farkas 1902].
struct Certificate {
  std::vector<Twist> motion;   ///< per cube, taken as velocities: m/s, rad/s; zero for what stands
  double power = 0.0;          ///< W, of the weights
  double worst_closing = 0.0;  ///< m/s, of the contact that closes fastest: rounding
};

enum class FailureMode {
  tips,    ///< over a corner
  slides,  ///< along what it lies on, or it is pressed out
  swings,  ///< on rods
  drops,   ///< nothing carries it
};

/// A part that falls whatever the rest does.
struct Cause {
  int island = -1;  ///< -1: it touches nothing
  int base = 0;     ///< the cube that carries the others of the part
  PartStand part;
  FailureMode failure = FailureMode::drops;
  std::vector<int> on;            ///< bodies that it presses on when it falls
  std::optional<Vec2> corner;     ///< m, about which it tips
  std::optional<double> outside;  ///< m, how far beside its support its weight acts
  int sense = 0;                  ///< to where it tips, slides or drops: +1 right, -1 left, 0 down
};

/// Cubes that move as one where nothing fails alone.
struct MovingPart {
  std::vector<int> cubes;
  Twist motion;               ///< m/s, rad/s, of the first cube
  int turn = 0;               ///< +1 left, -1 right
  std::optional<Vec2> pivot;  ///< m, where it presses hardest on something else
  std::vector<int> opens;     ///< bodies that it parts from
  double work_share = 0.0;    ///< of the weights' power
};

struct Causes {
  Certificate certificate;
  std::vector<Cause> causes;          ///< smallest part first
  std::vector<MovingPart> mechanism;  ///< of islands without causes
};

/// Of a scene that falls; empty of one that stands. In a scene in which nothing moves yet.
Causes find_causes(const StillScene& still);

/// The first cause alone; none where there is none.
std::optional<Cause> first_cause(const StillScene& still);

}  // namespace wuerfel
