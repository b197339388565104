/// How far a long job is, on stderr.
#pragma once

#include <string>

#include "app/cli/stopwatch.h"

namespace wuerfel {

/// A bar on a terminal, one line per 10 % elsewhere (where it takes longer than a second), and more
/// and more seldom where even that takes long; nothing where quiet is asked for.
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
  int last_tenth_ = 0;
  double next_line_ = 10.0;  // s on the watch
};

}  // namespace wuerfel
