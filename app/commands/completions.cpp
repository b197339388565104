#include "app/cli/completions.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "app/cli/choice.h"
#include "app/commands/commands.h"
#include "app/output/text_output.h"

namespace wuerfel {

namespace {

// What is not there yet.
void add_new(std::vector<DeclaredOption> more, std::vector<DeclaredOption>& options) {
  for (DeclaredOption& option : more) {
    if (std::ranges::find(options, option.names, &DeclaredOption::names) == options.end())
      options.push_back(std::move(option));
  }
}

// Of a family those of all its members.
std::vector<DeclaredOption> declared_options(const Command& command) {
  if (command.members == nullptr) {
    Options options{std::string(command.name), std::string(command.meaning)};
    command.declare(options);
    return options.declared();
  }
  std::vector<DeclaredOption> all;
  for (const Command& member : command.members())
    add_new(declared_options(member), all);
  return all;
}

std::vector<CommandOptions> declared_commands() {
  std::vector<CommandOptions> all;
  for (const Command& command : all_commands()) {
    all.push_back(
        {std::string(command.name), std::string(command.meaning), declared_options(command)});
  }
  return all;
}

}  // namespace

Action declare_completions(Options& options) {
  auto shell = std::make_shared<std::string>();
  options.argument("SHELL", join_choices(choices<Shell>()), *shell);
  return [shell](const Stopwatch&) {
    write_text("-",
               completion_script(parse_choice<Shell>("completions", *shell), declared_commands()));
    return ExitCode::fine;
  };
}

}  // namespace wuerfel
