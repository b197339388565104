/// Motion that has been computed, piece by piece.
#pragma once

#include <memory>
#include <vector>

#include "core/constraints/contact.h"
#include "core/time/events/dop853.h"

namespace wuerfel {

class PartialMotion;
struct StepRecord;

/// Components of a cube in the vector of a step: x, y, theta, then their rates.
inline constexpr std::size_t components = 6;

void pack(const State& state, std::vector<double>& y);
/// `state` must have as many cubes as `y` has components for.
void unpack(const std::vector<double>& y, State& state);

/// A stretch of a motion, to be looked at anywhere until the next one begins.
struct MotionPiece {
  enum class Kind { smooth, stepped, rest, part };
  Kind kind = Kind::smooth;
  double begin = 0.0;   ///< s
  double length = 0.0;  ///< s, of the polynomial; an event may have cut it short
  State start;
  DenseStep
      motion;  ///< of a smooth piece; empty where nobody was to look into its step (motion_of)
  /// Contacts that stay closed in a smooth piece, or carry load in a stepped one.
  std::vector<Contact> closed;
  std::shared_ptr<const StepRecord> record;  ///< of a stepped piece
  std::vector<Touch> touches{};              ///< of a smooth piece, closed
  std::vector<char> resting{};               ///< of a smooth piece, per cube, where there are rods
  std::shared_ptr<PartialMotion> part{};     ///< of a piece in which only a part moves
};

/// State at a share of a step, not yet projected. `state` must have the right number of cubes.
void look_at(const DenseStep& motion, double share, State& state);

}  // namespace wuerfel
