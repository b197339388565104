/// "Did you mean": the known word nearest to a misspelt one.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace wuerfel {

/// Ends a sentence that complains of `wrong`: `; did you mean "size"?`, or the list of what is
/// known (cut where long), or nothing where nothing is known.
std::string suggestion(std::string_view wrong, std::span<const std::string_view> known);

}  // namespace wuerfel
