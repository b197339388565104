/// "Did you mean": the known word nearest to a misspelt one.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wuerfel {

/// Ends a sentence that complains of `wrong`: `; did you mean "size"?`, or the list of what is
/// known (cut where long), or nothing where nothing is known.
std::string suggestion(std::string_view wrong, std::span<const std::string_view> known);

/// The same of the names of things, which outlive the call.
template <class Things, class Name = std::identity>
std::string suggestion(std::string_view wrong, const Things& things, Name name = {}) {
  std::vector<std::string_view> known;
  known.reserve(std::size(things));
  for (const auto& thing : things)
    known.emplace_back(std::invoke(name, thing));
  return suggestion(wrong, std::span<const std::string_view>(known));
}

}  // namespace wuerfel
