#include "core/scene/toml_reader.h"

#include <algorithm>
#include <optional>

#include <toml++/toml.h>

#include "core/scene/scene_text.h"

namespace wuerfel {
namespace {

Place place_of(const toml::source_region& region) {
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

Value convert(const toml::node& node) {
  Value value;
  value.place = place_of(node.source());
  if (const toml::table* table = node.as_table()) {
    Value::Table members;
    members.reserve(table->size());
    for (const auto& [key, item] : *table) {
      members.push_back({std::string(key.str()), place_of(key.source()), convert(item)});
    }
    // toml++ keeps its keys sorted; what people wrote first should be complained of first.
    std::sort(members.begin(), members.end(),
              [](const Member& a, const Member& b) { return written_before(a.place, b.place); });
    value.data = std::move(members);
  } else if (const toml::array* array = node.as_array()) {
    Value::Array items;
    items.reserve(array->size());
    for (const toml::node& item : *array) {
      items.push_back(convert(item));
    }
    value.data = std::move(items);
  } else if (const auto* text = node.as_string()) {
    value.data = text->get();
  } else if (const auto* integer = node.as_integer()) {
    value.data = integer->get();
  } else if (const auto* number = node.as_floating_point()) {
    value.data = number->get();
  } else if (const auto* boolean = node.as_boolean()) {
    value.data = boolean->get();
  } else {
    value.data = ForeignValue{"a date or time"};
  }
  return value;
}

void mark_as_override(Value& value, int override_at) {
  value.place.override_at = override_at;
  if (auto* table = std::get_if<Value::Table>(&value.data)) {
    for (Member& member : *table) {
      member.place.override_at = override_at;
      mark_as_override(member.value, override_at);
    }
  } else if (auto* items = std::get_if<Value::Array>(&value.data)) {
    for (Value& item : *items) {
      mark_as_override(item, override_at);
    }
  }
}

/// Something that was meant as a text: no number, no quotes or brackets.
bool is_plain_word(std::string_view text) {
  return !text.empty() && std::string_view("+-.0123456789").find(text[0]) == std::string_view::npos
         && text.find_first_of("\"'[]{}=") == std::string_view::npos;
}

}  // namespace

Value read_toml(std::string_view text, const SceneSource& source) {
  try {
    return convert(toml::parse(text, std::string_view(source.name)));
  } catch (const toml::parse_error& error) {
    source.fail(place_of(error.source()), "",
                "not valid TOML: " + std::string(error.description()));
  }
}

Value read_toml_value(std::string_view text, int override_at, const SceneSource& source) {
  const Place place{0, 0, override_at};
  if (text.find_first_of("\r\n") != std::string_view::npos) {
    source.fail(place, "", "the value must be on one line");
  }
  std::optional<Value> value;
  try {
    value = convert(toml::parse("value = " + std::string(text)));
  } catch (const toml::parse_error& error) {
    if (!is_plain_word(text)) {
      source.fail(place, "", "the value is not valid TOML: " + std::string(error.description()));
    }
    return {std::string(text), place};
  }
  mark_as_override(*value, override_at);
  return std::move(std::get<Value::Table>(value->data).front().value);
}

}  // namespace wuerfel
