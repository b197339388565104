/// Enumerations on the command line. Their names are those of `to_string`, so a new enumerator is
/// offered at once.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "app/cli/argument.h"
#include "app/cli/exit_code.h"

namespace wuerfel {

/// The names of all enumerators, in their order. `to_string` gives "?" past the last of them.
template <typename Enum>
std::vector<std::string> choices() {
  std::vector<std::string> names;
  for (int i = 0; to_string(static_cast<Enum>(i)) != "?"; ++i) {
    names.emplace_back(to_string(static_cast<Enum>(i)));
  }
  return names;
}

/// The enumerator of that name. Throws UsageError with the names there are.
template <typename Enum>
Enum parse_choice(std::string_view option, std::string_view text) {
  for (int i = 0; to_string(static_cast<Enum>(i)) != "?"; ++i) {
    if (to_string(static_cast<Enum>(i)) == text) return static_cast<Enum>(i);
  }
  throw UsageError(
      fmt::format("{}: '{}' is unknown; there is {}", option, text, join_choices(choices<Enum>())));
}

}  // namespace wuerfel
