/// When a run is looked at.
#pragma once

#include <vector>

#include "core/settings.h"

namespace wuerfel {

/// An instant at which the simulation stops to be looked at.
struct TimetableEntry {
  double t = 0.0;       ///< s, simulated
  bool frame = false;   ///< a picture, and a line of the tables
  bool sample = false;  ///< asked for by --sample, or -t
  bool look = false;    ///< forces are looked at, to be averaged in a picture to come
  bool scales = false;  ///< a frame whose forces the scales of arrows fit
  bool bare = false;    ///< a frame of which poses are enough
};

/// Whether somebody looks, be it to average.
inline bool is_seen(const TimetableEntry& instant) {
  return instant.frame || instant.sample || instant.look;
}

struct FrameRate {
  double fps = 60.0;   ///< frames per second of the film
  double speed = 1.0;  ///< simulated seconds per second of the film
};

/// How many frames there are from 0 to `end` s. Throws UsageError where they would fill memory and
/// disk long before they were of use.
long frame_count(double end, const FrameRate& rate);

/// Throws UsageError where steps of one length could never come to `end` s.
void require_possible_steps(double end, const MotionSettings& motion);

/// Times of the frames from 0 to `end` s, both included: k / fps * speed for k = 0 .. floor(end fps
/// / speed).
std::vector<double> frame_times(double end, const FrameRate& rate);

/// Marks the frames that scales fit: all of short films, of long ones evenly some forty, so that a
/// still picture need not know the forces of all frames to have the scales of its film.
void mark_scales(std::vector<TimetableEntry>& instants);

/// Frames, samples, other moments to stop at and the end in one order in time, every instant once; the times are exactly
/// those given.
std::vector<TimetableEntry> timetable(double end,
                                      const std::vector<double>& frames,
                                      const std::vector<double>& samples,
                                      const std::vector<double>& marks = {});

/// Both in one order in time, every instant once: equal ones become one that is everything they were.
std::vector<TimetableEntry> merged(std::vector<TimetableEntry> instants,
                                   const std::vector<TimetableEntry>& more);

}  // namespace wuerfel
