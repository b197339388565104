#include "core/scene/json_string.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace wuerfel {

std::string json_string(const std::string& text) {
  using nlohmann::json;
  const auto is_plain = [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; };
  if (std::ranges::all_of(text, is_plain)) return '"' + text + '"';
  return json(text).dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace wuerfel
