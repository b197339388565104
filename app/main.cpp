#include <csignal>
#include <exception>
#include <new>

#include <fmt/core.h>

#include "app/cli/command_line.h"
#include "app/cli/stop_signal.h"
#include "core/scene/scene_parser.h"
#include "render/error.h"

namespace {

using namespace wuerfel;  // NOLINT(google-build-using-namespace): main is a name of no namespace

int complain(const char* message, ExitCode code) {
  fmt::print(stderr, "wuerfel: {}\n", message);
  return static_cast<int>(code);
}

}  // namespace

/// Runs the subcommand; every error ends here, as a message and an exit code.
int main(int argc, char** argv) {
  const Stopwatch since_start;
  // A pipe that nobody reads and a file that may not grow are errors of writing, not the end.
  std::signal(SIGPIPE, SIG_IGN);  // NOLINT(cert-err33-c)
  std::signal(SIGXFSZ, SIG_IGN);  // NOLINT(cert-err33-c)
  try {
    const auto command = parse_command_line(argc, argv, since_start);
    return static_cast<int>(command ? (*command)() : ExitCode::fine);
  } catch (const UsageError& error) {
    return complain(error.what(), ExitCode::bad_input);
  } catch (const SceneError& error) {
    return complain(error.what(), ExitCode::bad_input);
  } catch (const OutputError& error) {
    return complain(error.what(), ExitCode::output);
  } catch (const Interrupted& interrupted) {
    return 128 + interrupted.signal;
  } catch (const std::bad_alloc&) {
    return complain("out of memory", ExitCode::internal);
  } catch (const std::exception& error) {
    return complain(error.what(), ExitCode::internal);
  }
}
