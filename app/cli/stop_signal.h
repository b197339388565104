/// Ctrl-C and its relatives: asked for, never obeyed in the middle of a file.
#pragma once

#include <array>
#include <csignal>

namespace wuerfel {

/// A signal asked the program to stop. Exit code 128 + number.
struct Interrupted {
  int signal = 0;
};

/// While it lives, SIGINT, SIGTERM and SIGHUP only leave a note (those the caller had ignored stay
/// ignored). A second one of the same kind ends the program at once.
class StopSignal {
 public:
  enum class Ear {
    open,
    deaf,  ///< leaves all signals as they are: where the program is another one's
  };
  explicit StopSignal(Ear ear = Ear::open);
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  /// Throws Interrupted if there is a note, MemoryExceeded where --max-memory is passed.
  void check() const;

 private:
  Ear ear_;
  static constexpr std::array<int, 3> handled{SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, 3> before_{};
};

}  // namespace wuerfel
