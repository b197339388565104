#include "app/commands/commands.h"

#include <algorithm>
#include <array>

#include <fmt/core.h>

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
};

std::string help() {
  std::string text =
      "Falling cubes in the plane by Gauss' principle of least constraint.\n"
      "Usage: wuerfel COMMAND [OPTIONS]\n\nCommands:\n";
  for (const Command& command : commands)
    text += fmt::format("  {:<12}{}\n", command.name, command.meaning);
  return text +
         "\nOptions:\n"
         "  -h,--help   print this, or behind a command its options\n"
         "  --version   print the version\n";
}

[[noreturn]] void refuse(const std::string& name) {
  std::vector<std::string_view> names;
  std::ranges::transform(commands, std::back_inserter(names), &Command::name);
  throw UsageError(fmt::format("there is no {} {}{}", name.starts_with('-') ? "option" : "command",
                               name, suggestion(name, names)));
}

}  // namespace

std::span<const Command> all_commands() { return commands; }

ExitCode run_command(const std::vector<std::string>& arguments, const Stopwatch& since_start) {
  if (arguments.empty()) throw UsageError("a command is missing (see wuerfel --help)");
  const std::string& name = arguments.front();
  if (name == "--help" || name == "-h") {
    write_text("-", help());
    return ExitCode::fine;
  }
  if (name == "--version") {
    write_text("-", "wuerfel " WUERFEL_VERSION "\n");
    return ExitCode::fine;
  }
  const auto command = std::ranges::find(commands, name, &Command::name);
  if (command == commands.end()) refuse(name);
  Options options(fmt::format("wuerfel {}", name), std::string(command->meaning));
  const Action action = command->declare(options);
  if (options.parse({arguments.begin() + 1, arguments.end()})) return action(since_start);
  write_text("-", options.help());
  return ExitCode::fine;
}

}  // namespace wuerfel
