/// Text -> JSON.
#pragma once

#include <string>

namespace wuerfel {

/// A text in quotes, as JSON has it; bytes that are no UTF-8 become U+FFFD.
std::string json_string(const std::string& text);

}  // namespace wuerfel
