/// Text in XML.
#pragma once

#include <string>
#include <string_view>

namespace wuerfel::internal {

/// Characters that mean something in XML as entities; control characters, which XML 1.0 cannot have,
/// as blanks.
std::string xml_escaped(std::string_view text);

/// The text of what `xml_escaped` wrote.
std::string xml_unescaped(std::string_view text);

}  // namespace wuerfel::internal
