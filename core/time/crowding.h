/// Whether events crowd, and for how long steps take over then.
#pragma once

namespace wuerfel {

/// Frames per L / V: what happens within one is near.
inline constexpr double frames_per_time = 20.0;

/// Counts events in frames of L / V / 20. More of them in one frame than the group can afford hand over
/// to stepping; it lasts for 1, 2, 4 .. 32 frames, each time it is needed again soon.
class Crowding {
 public:
  /// `only_events`: only 500 events in a frame are too many.
  Crowding(int cubes, bool only_events) : cubes_(cubes), only_events_(only_events) {}

  /// The count begins anew at t, with what was known of the cubes. `time` is L / V, s.
  void begin(double time, double t, int patience);
  [[nodiscard]] double frame() const { return frame_; }     ///< s
  [[nodiscard]] int patience() const { return patience_; }  ///< frames that the next stepping lasts
  /// The first frame's end after t that is `frames` frames away.
  [[nodiscard]] double frames_after(double t, double frames) const;

  /// What has happened until t: events, and steps of what touches.
  void count(double t, long events, long steps);
  /// Whether there are too many of either in this frame.
  [[nodiscard]] bool crowds() const;
  /// Whether there are not too many in this frame nor in the one before.
  [[nodiscard]] bool calm() const;

  /// Stepping begins at t: returns until when it lasts, s.
  double step_from(double t);
  /// Stepping was over at t: events are counted anew.
  void step_to(double t);

 private:
  [[nodiscard]] long affordable() const;

  int cubes_;
  bool only_events_;
  double frame_ = 0.0;  ///< s
  long number_ = 0;     ///< of the frame in which events are counted
  long events_ = 0;
  long steps_ = 0;
  long former_events_ = 0;  ///< of the frame before
  int patience_ = 1;
  double stepped_to_ = 0.0;  ///< s
};

}  // namespace wuerfel
