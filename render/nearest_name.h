/// "Did you mean": the known name that is nearest to a mistyped one.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace wuerfel {

/// ", did you mean 'forces'?" if a name is near enough (edit distance at most a third of its
/// length), and else
/// "; known: a, b, c".
std::string nearest_name_hint(std::string_view mistyped, std::span<const std::string_view> known);

}  // namespace wuerfel
