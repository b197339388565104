/// What the program tells its caller.
#pragma once

#include <stdexcept>

namespace wuerfel {

enum class ExitCode {
  fine = 0,
  negative = 1,   ///< falls or moves; pictures differ
  bad_input = 2,  ///< usage or scene error
  undecided = 3,  ///< or over the error budget
  internal = 4,
  output = 5,  ///< a file could not be written, or ffmpeg failed
  again = 75,  ///< out of time with work left: call again (EX_TEMPFAIL of sysexits.h)
};

/// The command line asks for something that does not exist or makes no sense. Exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace wuerfel
