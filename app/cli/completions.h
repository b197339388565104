/// Completions for shells, written from what the commands declare.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/options.h"

namespace wuerfel {

enum class Shell { bash, zsh, fish };
std::string_view to_string(Shell shell);

/// A command and the options it declares.
struct CommandOptions {
  std::string name;
  std::string meaning;
  std::vector<DeclaredOption> options;
};

/// The script that teaches a shell the commands, their options and the values of these. Scenes that
/// come along are asked of the program itself.
std::string completion_script(Shell shell, const std::vector<CommandOptions>& commands);

}  // namespace wuerfel
