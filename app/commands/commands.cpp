#include "app/commands/commands.h"

#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "app/commands/sweep.h"
#include "app/output/text_output.h"
#include "core/scene/suggestion.h"

namespace wuerfel {

namespace {

constexpr std::array commands{
    Command{"run", "simulate a scene and write frames, films and tables", declare_run},
    Command{"check", "tell whether a scene stands: exit 0 stands, 1 falls or moves, 3 undecided",
            declare_check},
    Command{"explain", "tell why a scene falls and what would help, or how nearly it stands",
            declare_explain},
    Command{"figure", "draw one instant, or a strip of several", declare_figure},
    Command{"compare",
            "tell whether pictures, or folders of them, are the same: exit 0 same, 1 differs",
            declare_compare},
    Command{"reproduce", "make a picture again from what it carries: exit 0 same, 1 differs",
            declare_reproduce},
    Command{"replay", "solve programs again that a run could not: exit 0 solved, 3 not",
            declare_replay},
    Command{"scenes", "list the scenes that come along, or print one", declare_scenes},
    Command{"schema", "print the JSON Schema of scenes", declare_schema},
    Command{"completions", "print what teaches bash, zsh or fish these commands and options",
            declare_completions},
    Command{"sweep", "make data sets: plan, run, status, merge, verify, sheet, template", nullptr,
            sweep_commands},
};

std::string list_of(std::span<const Command> family) {
  std::string text;
  for (const Command& command : family)
    text += fmt::format("  {:<12}{}\n", command.name, command.meaning);
  return text;
}

std::string help() {
  return "Falling cubes in the plane by Gauss' principle of least constraint.\n"
         "Usage: wuerfel COMMAND [OPTIONS]\n\nCommands:\n"
         + list_of(commands)
         + "\nOptions:\n"
           "  -h,--help   print this, or behind a command its options\n"
           "  --version   print the version\n";
}

std::string help_of(const std::string& program, const Command& family) {
  return fmt::format("{}\nUsage: {} COMMAND [OPTIONS]\n\nCommands:\n{}", family.meaning, program,
                     list_of(family.members()));
}

[[noreturn]] void refuse(const std::string& name, std::span<const Command> family) {
  throw UsageError(fmt::format("there is no {} {}{}", name.starts_with('-') ? "option" : "command",
                               name, suggestion(name, family, &Command::name)));
}

/// A line that begins with the name of a command of the family; `program` is what stood before it.
ExitCode run_member(std::span<const Command> family,
                    const std::string& program,
                    std::span<const std::string> line,
                    const Stopwatch& since_start) {
  if (line.empty()) throw UsageError(fmt::format("a command is missing (see {} --help)", program));
  const auto command = std::ranges::find(family, line.front(), &Command::name);
  if (command == family.end()) refuse(line.front(), family);
  const std::string name = fmt::format("{} {}", program, command->name);
  line = line.subspan(1);
  if (command->members != nullptr) {
    if (line.empty() || (line.front() != "--help" && line.front() != "-h"))
      return run_member(command->members(), name, line, since_start);
    write_text("-", help_of(name, *command));
    return ExitCode::fine;
  }
  Options options(name, std::string(command->meaning));
  const Action action = command->declare(options);
  if (options.parse({line.begin(), line.end()})) return action(since_start);
  write_text("-", options.help());
  return ExitCode::fine;
}

}  // namespace

std::span<const Command> all_commands() { return commands; }

ExitCode run_command(const std::vector<std::string>& arguments, const Stopwatch& since_start) {
  const std::string first = arguments.empty() ? "" : arguments.front();
  if (first == "--help" || first == "-h") {
    write_text("-", help());
    return ExitCode::fine;
  }
  if (first == "--version") {
    write_text("-", "wuerfel " WUERFEL_VERSION "\n");
    return ExitCode::fine;
  }
  return run_member(commands, "wuerfel", arguments, since_start);
}

}  // namespace wuerfel
