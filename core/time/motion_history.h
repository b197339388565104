/// What has been computed of a motion and is not forgotten, to be looked at.
#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "core/geometry/bounds.h"
#include "core/time/events/event_motion.h"
#include "core/time/stepping/step_look.h"

namespace wuerfel {

class MotionHistory {
 public:
  MotionHistory(const System& system, const MotionSettings& settings)
      : system_(&system), settings_(settings) {}

  /// In the order of time, each until the next one begins.
  [[nodiscard]] std::deque<MotionPiece>& pieces() { return pieces_; }
  [[nodiscard]] const std::deque<MotionPiece>& pieces() const { return pieces_; }
  /// The piece in which a time before the end of all lies; none where it is not known.
  [[nodiscard]] const MotionPiece* piece_at(double t) const;
  /// State at a time, just after events; `end` that of the end, and where the time is not known. `events` moved smooth pieces.
  [[nodiscard]] State at(double t, const State& end, EventMotion& events);
  void forget_before(double t);
  /// Bounds of what each cube swept since `t`, blown up by its half diagonal; the motion has come to `end` at `clock`.
  void sweep(double t, double clock, const State& end, std::vector<BoundingBox>& bounds) const;

 private:
  [[nodiscard]] std::ptrdiff_t number_at(double t) const;

  const System* system_;
  MotionSettings settings_;
  std::deque<MotionPiece> pieces_;
  std::unique_ptr<StepLook> look_;  ///< none before the first look between steps
};

}  // namespace wuerfel
