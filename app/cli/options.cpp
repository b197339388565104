#include "app/cli/options.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "app/cli/exit_code.h"
#include "core/scene/suggestion.h"

namespace wuerfel {

namespace {

using Text = std::string;

CLI::Option* add_value(CLI::App& app,
                       const Text& names,
                       const Text& type,
                       const Text& meaning,
                       const Options::Take& take) {
  return app
      .add_option_function<std::vector<Text>>(
          names, [take](const std::vector<Text>& values) { std::ranges::for_each(values, take); },
          meaning)
      ->type_name(type)
      ->allow_extra_args(false);
}

// What is empty was meant to be something: a variable of a shell, perhaps.
Text told(const Text& value) { return value.empty() ? "must not be empty" : ""; }

std::vector<Text> words_of(const Text& line) {
  std::vector<Text> words;
  bool within_quotes = false;
  bool within_word = false;
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (line[k] == ' ' && !within_quotes) {
      within_word = false;
      continue;
    }
    if (!within_word) words.emplace_back();
    within_word = true;
    const bool escapes = within_quotes && line[k] == '\\' && k + 1 < line.size()
                         && (line[k + 1] == '"' || line[k + 1] == '\\');
    if (line[k] == '"') {
      within_quotes = !within_quotes;
    } else {
      words.back() += line[escapes ? ++k : k];
    }
  }
  return words;
}

}  // namespace

std::string quoted_word(std::string_view word) {
  Text text = "\"";
  for (const char c : word) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + '"';
}

Options::Options(const Text& command, const Text& meaning)
    : app_(std::make_unique<CLI::App>(meaning, command)) {
  app_->get_formatter()->label("Positionals", "Arguments");
  app_->get_formatter()->label("REQUIRED", "");
}

Options::~Options() = default;

void Options::argument(const Text& name, const Text& meaning, Text& value) {
  app_->add_option(name, value, meaning)->required()->type_name("")->check(told);
}

void Options::optional_argument(const Text& name, const Text& meaning, Text& value) {
  app_->add_option(name, value, meaning)->type_name("")->check(told);
}

void Options::arguments(const Text& name, const Text& meaning, std::vector<Text>& values) {
  app_->add_option(name, values, meaning)->required()->type_name("")->check(told);
}

void Options::value(const Text& names, const Text& type, const Text& meaning, const Take& take) {
  add_value(*app_, names, type, meaning, take);
}

void Options::single(const Text& names, const Text& type, const Text& meaning, const Take& take) {
  add_value(*app_, names, type, meaning, take)->expected(1);
}

void Options::text(const Text& names, const Text& type, const Text& meaning, Text& value) {
  app_->add_option(names, value, meaning)->type_name(type)->check(told);
}

void Options::required_text(const Text& names, const Text& type, const Text& meaning, Text& value) {
  app_->add_option(names, value, meaning)->type_name(type)->required()->check(told);
}

void Options::optional_value(const Text& name,
                             const Text& type,
                             const Text& meaning,
                             std::function<bool(const Text&)> fits,
                             const Take& take) {
  optional_values_[name] = std::move(fits);
  single(name, type, meaning, take);
}

// `--name TEXT` as `--name=TEXT`, and `--name` alone as `--name=all`: what follows is an argument.
void Options::join_optional_values(std::vector<Text>& arguments) const {
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    const auto optional = optional_values_.find(arguments[k]);
    if (optional == optional_values_.end()) continue;
    if (k + 1 == arguments.size() || !optional->second(arguments[k + 1])) {
      arguments[k] += "=all";
      continue;
    }
    arguments[k] += '=' + arguments[k + 1];
    arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(k) + 1);
  }
}

void Options::flag(const Text& names, const Text& meaning, bool& value) {
  app_->add_flag(names, value, meaning)->disable_flag_override();
}

void Options::offer(const Text& name, std::vector<Text> values) {
  values_[name] = std::move(values);
}

bool Options::parse(std::vector<Text> arguments) {
  join_optional_values(arguments);
  std::ranges::reverse(arguments);  // CLI11 takes them from the end
  try {
    app_->parse(std::move(arguments));
  } catch (const CLI::CallForHelp&) {
    return false;
  } catch (const CLI::ParseError& error) {
    throw UsageError(fmt::format("{} (see {} --help)", complaint(error.what()), app_->get_name()));
  }
  return true;
}

void Options::parse_line(const Text& line) {
  std::vector<Text> words = words_of(line);
  std::ranges::reverse(words);
  try {
    app_->parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    throw UsageError(complaint(error.what()));
  }
}

namespace {

// Where CLI11 only counts.
Text in_words(const CLI::App& app, const Text& otherwise) {
  for (const CLI::Option* option : app.get_options({})) {
    const bool one = option->get_type_size() > 0 && option->get_expected_max() == 1;
    if (one && option->count() > 1) return option->get_name() + " is given more than once";
    if (otherwise == CLI::ArgumentMismatch::FlagOverride(option->get_single_name()).what())
      return option->get_name() + " takes no value";
    const Text type = option->get_type_name();
    if (otherwise == CLI::ArgumentMismatch::TypedAtLeast(option->get_name(), 1, type).what())
      return fmt::format("{} needs a value, {}", option->get_name(), type);
  }
  return otherwise;
}

}  // namespace

// What CLI11 did not know tells more than what it missed in its place.
Text Options::complaint(const Text& otherwise) const {
  std::vector<Text> names;
  for (const CLI::Option* option : app_->get_options({})) {
    for (const Text& name : option->get_lnames())
      names.push_back("--" + name);
  }
  const std::vector<Text> unknown = app_->remaining();
  const auto dashed = std::ranges::find_if(
      unknown, [](const Text& text) { return text.size() > 1 && text.starts_with('-'); });
  if (dashed != unknown.end()) {
    const Text name = dashed->substr(0, dashed->find('='));
    return fmt::format("there is no option {}{}", name, suggestion(name, names));
  }
  if (!unknown.empty()) return fmt::format("'{}' is one argument too many", unknown.front());
  return in_words(*app_, otherwise);
}

Text Options::help() const { return app_->help(); }

std::vector<DeclaredOption> Options::declared() const {
  std::vector<DeclaredOption> all;
  for (const CLI::Option* option : app_->get_options({})) {
    if (option->get_positional()) continue;
    DeclaredOption declared;
    declared.type = option->get_type_size() == 0 ? "" : option->get_type_name();
    declared.meaning = option->get_description();
    for (const Text& name : option->get_lnames())
      declared.names.push_back("--" + name);
    for (const Text& name : option->get_snames())
      declared.names.push_back("-" + name);
    if (const auto found = values_.find(declared.names.front()); found != values_.end())
      declared.values = found->second;
    all.push_back(std::move(declared));
  }
  return all;
}

bool Options::given(const Text& name) const { return app_->count(name) > 0; }

}  // namespace wuerfel
