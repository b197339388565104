/// The text of a scene before anyone parses it: language, encoding, size and depth.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/scene/value.h"

namespace wuerfel {

/// Longest scene text that is read, in bytes.
inline constexpr std::size_t longest_text = std::size_t{128} << 20U;

/// Deepest nesting of brackets, and most dots in one key. A scene needs three; parsers and
/// destructors that recurse would not survive a hundred thousand.
inline constexpr int deepest_nesting = 16;

enum class SceneLanguage { toml, json };

/// JSON if the first character that is not white space is '{' or the name ends in ".json", else
/// TOML.
SceneLanguage language_of(std::string_view text, std::string_view name);

/// Line and column (1-based, in characters) of the byte at `offset`.
Place place_at(std::string_view text, std::size_t offset);

/// What keeps a text from being read, and the byte where it begins.
struct TextFault {
  std::size_t offset = 0;
  std::string message;
};

/// First fault of `text`: longer than longest_text, a zero byte, not UTF-8, or nested deeper than
/// deepest_nesting.
std::optional<TextFault> find_text_fault(std::string_view text, SceneLanguage language);

/// Throws SceneError at line:column where `text` is empty or has a fault.
void check_text(std::string_view text, SceneLanguage language, const SceneSource& source);

}  // namespace wuerfel
