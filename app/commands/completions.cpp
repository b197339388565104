#include "app/cli/completions.h"

#include <memory>

#include "app/cli/choice.h"
#include "app/commands/commands.h"
#include "app/output/text_output.h"

namespace wuerfel {

namespace {

std::vector<CommandOptions> declared_commands() {
  std::vector<CommandOptions> all;
  for (const Command& command : all_commands()) {
    Options options{std::string(command.name), std::string(command.meaning)};
    command.declare(options);
    all.push_back({std::string(command.name), std::string(command.meaning), options.declared()});
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
