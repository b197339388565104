/// TOML text -> Value, through toml++.
#pragma once

#include <string_view>

#include "core/scene/value.h"

namespace wuerfel {

/// The document as a table, members in the order of the text. Throws SceneError at line:column
/// where it is not TOML. `text` has passed check_text.
Value read_toml(std::string_view text, const SceneSource& source);

/// The value of the override with index `override_at`: `text` as TOML, or, where it is not TOML but
/// a plain word, the word as a text (so that a shell needs no quotes). Throws SceneError that names
/// the override.
Value read_toml_value(std::string_view text, int override_at, const SceneSource& source);

}  // namespace wuerfel
