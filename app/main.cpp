#include <csignal>

#include "app/cli/failure.h"
#include "app/cli/memory_limit.h"
#include "app/cli/stop_signal.h"
#include "app/cli/streams.h"
#include "app/commands/commands.h"

/// Runs the command that the line names; every error ends here, as a message and an exit code.
int main(int argc, char** argv) {
  const wuerfel::Stopwatch since_start;
  // A pipe that nobody reads and a file that may not grow are errors of writing, not the end.
  std::signal(SIGPIPE, SIG_IGN);  // NOLINT(cert-err33-c)
  std::signal(SIGXFSZ, SIG_IGN);  // NOLINT(cert-err33-c)
  wuerfel::hold_standard_streams();
  wuerfel::keep_freed_memory();
  try {
    return static_cast<int>(wuerfel::run_command({argv + 1, argv + argc}, since_start));
  } catch (const wuerfel::Interrupted& interrupted) {
    return 128 + interrupted.signal;
  } catch (...) {
    const wuerfel::Failure failure = wuerfel::failure_of(std::current_exception());
    wuerfel::complain(failure.message);
    return static_cast<int>(failure.code);
  }
}
