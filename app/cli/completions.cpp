#include "app/cli/completions.h"

#include <algorithm>

#include <fmt/format.h>

namespace wuerfel {

namespace {

using Text = std::string;

// What a shell asks of the program while it completes.
constexpr std::string_view scene_names = "wuerfel scenes 2>/dev/null | cut -d' ' -f1";

// In single quotes, for any shell.
Text in_quotes(std::string_view text) {
  Text quoted = "'";
  for (const char letter : text)
    quoted += letter == '\'' ? Text("'\\''") : Text(1, letter);
  return quoted + "'";
}

std::vector<Text> names_of(const CommandOptions& command) {
  std::vector<Text> names;
  for (const DeclaredOption& option : command.options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

Text bash_values(const CommandOptions& command) {
  Text text;
  for (const DeclaredOption& option : command.options) {
    if (option.type.empty()) continue;
    const Text action =
        option.values.empty()
            ? "COMPREPLY=($(compgen -f -- \"$word\"))"
            : fmt::format("COMPREPLY=($(compgen -W {} -- \"$word\"))",
                          in_quotes(fmt::format("{}", fmt::join(option.values, " "))));
    text += fmt::format("    '{0} {1}') {2}; return ;;\n", command.name,
                        fmt::join(option.names, fmt::format("'|'{} ", command.name)), action);
  }
  return text;
}

Text bash(const std::vector<CommandOptions>& commands) {
  Text values;
  Text options;
  std::vector<Text> names;
  for (const CommandOptions& command : commands) {
    names.push_back(command.name);
    values += bash_values(command);
    options +=
        fmt::format("      {}) known='{}' ;;\n", command.name, fmt::join(names_of(command), " "));
  }
  return fmt::format(
      R"script(# Completions of wuerfel for bash: source them, or put them where bash-completion looks.
_wuerfel() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} known=''
  if ((COMP_CWORD == 1)); then
    COMPREPLY=($(compgen -W '{0} --help --version' -- "$word"))
    return
  fi
  case "${{COMP_WORDS[1]}} ${{COMP_WORDS[COMP_CWORD - 1]}}" in
{1}  esac
  if [[ $word == -* ]]; then
    case "${{COMP_WORDS[1]}}" in
{2}    esac
    COMPREPLY=($(compgen -W "$known" -- "$word"))
    return
  fi
  COMPREPLY=($(compgen -W "$({3})" -- "$word") $(compgen -f -- "$word"))
}}
complete -o filenames -F _wuerfel wuerfel
)script",
      fmt::join(names, " "), values, options, scene_names);
}

// A colon ends a part of a specification, and brackets end a meaning.
Text zsh_meaning(std::string_view meaning) {
  Text text;
  for (const char letter : meaning) {
    if (letter == ':' || letter == '[' || letter == ']') text += '\\';
    text += letter;
  }
  return text;
}

Text zsh_option(const DeclaredOption& option, const Text& name) {
  const Text values =
      option.values.empty() ? Text("_files") : fmt::format("({})", fmt::join(option.values, " "));
  const Text value =
      option.type.empty() ? "" : fmt::format(":{}:{}", zsh_meaning(option.type), values);
  return in_quotes(fmt::format("*{}[{}]{}", name, zsh_meaning(option.meaning), value));
}

Text zsh(const std::vector<CommandOptions>& commands) {
  Text list;
  Text cases;
  for (const CommandOptions& command : commands) {
    list += "    " + in_quotes(command.name + ":" + command.meaning) + "\n";
    cases += fmt::format("    {}) _arguments", command.name);
    for (const DeclaredOption& option : command.options) {
      for (const Text& name : option.names)
        cases += " \\\n      " + zsh_option(option, name);
    }
    cases += " \\\n      '*:scene:_wuerfel_scenes' ;;\n";
  }
  return fmt::format(R"script(#compdef wuerfel
# Completions of wuerfel for zsh: a file _wuerfel in a folder of $fpath.
_wuerfel_scenes() {{
  local -a scenes
  scenes=(${{(f)"$({2})"}})
  compadd -a scenes
  _files
}}
_wuerfel() {{
  local -a commands
  commands=(
{0}  )
  if ((CURRENT == 2)); then
    _describe command commands
    return
  fi
  shift words
  ((CURRENT--))
  case $words[1] in
{1}  esac
}}
_wuerfel "$@"
)script",
                     list, cases, scene_names);
}

Text fish_option(const CommandOptions& command, const DeclaredOption& option) {
  Text line = fmt::format("complete -c wuerfel -n '__fish_seen_subcommand_from {}'", command.name);
  for (const Text& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.type.empty()) line += " -r";
  if (!option.values.empty())
    line += " -f -a " + in_quotes(fmt::format("{}", fmt::join(option.values, " ")));
  return line + " -d " + in_quotes(option.meaning) + "\n";
}

Text fish(const std::vector<CommandOptions>& commands) {
  Text text = "# Completions of wuerfel for fish.\n";
  for (const CommandOptions& command : commands) {
    text += fmt::format("complete -c wuerfel -n __fish_use_subcommand -f -a {} -d {}\n",
                        command.name, in_quotes(command.meaning));
  }
  for (const CommandOptions& command : commands) {
    for (const DeclaredOption& option : command.options)
      text += fish_option(command, option);
  }
  return text
         + fmt::format("complete -c wuerfel -n 'not __fish_use_subcommand' -a \"({})\"\n",
                       scene_names);
}

}  // namespace

std::string_view to_string(Shell shell) {
  switch (shell) {
    case Shell::bash:
      return "bash";
    case Shell::zsh:
      return "zsh";
    case Shell::fish:
      return "fish";
  }
  return "?";
}

std::string completion_script(Shell shell, const std::vector<CommandOptions>& commands) {
  switch (shell) {
    case Shell::bash:
      return bash(commands);
    case Shell::zsh:
      return zsh(commands);
    case Shell::fish:
      return fish(commands);
  }
  return {};
}

}  // namespace wuerfel
