#include "render/vector/xml.h"

#include <algorithm>
#include <array>
#include <utility>

namespace wuerfel::internal {
namespace {

constexpr std::array<std::pair<char, std::string_view>, 4> entities{
    {{'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'&', "&amp;"}}};

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20U && c != '\n' && c != '\t' && c != '\r';
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    const auto* const entity =
        std::ranges::find(entities, c, [](const auto& e) { return e.first; });
    if (entity != entities.end()) {
      escaped += entity->second;
    } else {
      escaped += is_control(c) ? ' ' : c;
    }
  }
  return escaped;
}

std::string xml_unescaped(std::string_view text) {
  std::string plain;
  while (!text.empty()) {
    const auto* const entity = std::ranges::find_if(
        entities, [text](const auto& e) { return text.starts_with(e.second); });
    const bool found = entity != entities.end();
    plain += found ? entity->first : text.front();
    text.remove_prefix(found ? entity->second.size() : 1);
  }
  return plain;
}

}  // namespace wuerfel::internal
