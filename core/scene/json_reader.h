/// JSON text -> Value, through nlohmann::json's event parser (no recursion, no silent loss of
/// repeated keys).
#pragma once

#include <string_view>

#include "core/scene/value.h"

namespace wuerfel {

/// The document as a value, members in the order of the text, repeated keys kept. Throws SceneError
/// at line:column where it is not JSON or a number is too large for a double. `text` has passed
/// check_text.
Value read_json(std::string_view text, const SceneSource& source);

}  // namespace wuerfel
