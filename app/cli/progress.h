/// How far a long job is, on stderr.
#pragma once

#include <string>

#include "app/cli/stopwatch.h"

namespace wuerfel {

/// When a log gets a line of a long job: once per tenth of it, and at 10 s, 40 s, 160 s .. where a
/// tenth takes longer. Nothing is told of what is over within a second.
class LogSchedule {
 public:
  /// Whether a line is due where `share` of the job, 0 to 1, took `elapsed` s; it counts as written.
  bool due(double share, double elapsed);

 private:
  int last_tenth_ = 0;
  double next_line_ = 10.0;  // s
};

/// A bar on a terminal, lines by LogSchedule elsewhere; nothing where quiet is asked for.
class Progress {
 public:
  enum class Style { silent, lines, bar, coloured_bar };

  /// What suits stderr and the environment (NO_COLOR, TERM).
  static Style style_for_stderr(bool quiet);

  /// `total` in `unit`, as in 240 "frames".
  Progress(Style style, std::string label, double total, std::string unit);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` of `total` is done.
  void reached(double done);
  /// Leaves the bar as it is and goes to the next line; the destructor does so too.
  void end();

 private:
  [[nodiscard]] std::string text(double done) const;
  void draw_bar(double done);

  Style style_;
  std::string label_;
  double total_;
  std::string unit_;
  Stopwatch watch_;
  double last_drawn_ = -1.0;  // s on the watch
  LogSchedule schedule_;
};

}  // namespace wuerfel
