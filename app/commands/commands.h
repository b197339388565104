/// The commands of the program: a table of their names, what they are for, and how they are read.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/exit_code.h"
#include "app/cli/options.h"
#include "app/cli/stopwatch.h"

namespace wuerfel {

/// What a command does once its options are read; the watch runs since the start of the program.
using Action = std::function<ExitCode(const Stopwatch& since_start)>;

struct Command {
  std::string_view name;
  std::string_view meaning;
  /// Declares the options of the command, and only those: the program starts faster without what
  /// the others have.
  Action (*declare)(Options& options);
  /// Where the command is a family: its members, each with options of its own.
  std::span<const Command> (*members)() = nullptr;
};

std::span<const Command> all_commands();

/// The command that the first of the arguments names, told the others. Throws UsageError, and what
/// the command throws.
ExitCode run_command(const std::vector<std::string>& arguments, const Stopwatch& since_start);

// Each in the file of its name.
Action declare_run(Options& options);
Action declare_check(Options& options);
Action declare_explain(Options& options);
Action declare_figure(Options& options);
Action declare_compare(Options& options);
Action declare_reproduce(Options& options);
Action declare_replay(Options& options);
Action declare_scenes(Options& options);
Action declare_schema(Options& options);
Action declare_completions(Options& options);

}  // namespace wuerfel
