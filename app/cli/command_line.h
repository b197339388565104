/// The command line: which subcommand, told what.
#pragma once

#include <functional>
#include <optional>

#include "app/cli/exit_code.h"
#include "app/cli/stopwatch.h"

namespace wuerfel {

using Command = std::function<ExitCode()>;

/// None where the line was answered at once, as --help is. Throws UsageError.
std::optional<Command> parse_command_line(int argc,
                                          const char* const* argv,
                                          const Stopwatch& since_start);

}  // namespace wuerfel
