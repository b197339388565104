#include "core/scene/override.h"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/scene/scene_text.h"
#include "core/scene/suggestion.h"
#include "core/scene/toml_reader.h"

namespace wuerfel {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

Member* find_member(Value::Table& table, std::string_view key) {
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const Member& m) { return m.key == key; });
  return found == table.end() ? nullptr : &*found;
}

void set_member(Value::Table& table, std::string_view key, Value value) {
  if (Member* member = find_member(table, key)) {
    member->place = value.place;
    member->value = std::move(value);
  } else {
    const Place place = value.place;
    table.push_back({std::string(key), place, std::move(value)});
  }
}

/// Name by which an element of an array of tables is known: its own, or the default one (cube2).
std::string element_name(const Value& element, std::string_view kind, std::size_t index) {
  if (const auto* table = std::get_if<Value::Table>(&element.data)) {
    const Member* name = wuerfel::find_member(*table, "name");
    const auto* text = name == nullptr ? nullptr : std::get_if<std::string>(&name->value.data);
    if (text != nullptr) return *text;
  }
  return fmt::format("{}{}", kind, index + 1);
}

/// One override while it is applied: its key in up to three parts.
class Override {
 public:
  Override(int index, const SceneSource& source) : place_{0, 0, index}, source_(source) {}

  void apply(Value& document) const {
    const std::string_view text = source_.overrides[place_.override_at];
    if (const auto fault = find_text_fault(text, SceneLanguage::toml)) fail(fault->message);
    const std::size_t equals = text.find('=');
    const std::string_view path = trimmed(text.substr(0, equals));
    if (equals == std::string_view::npos || path.empty()) fail("must be KEY=VALUE");
    auto* table = std::get_if<Value::Table>(&document.data);
    if (table == nullptr) source_.fail(document.place, "", "a scene must be a table of keys");
    set(*table, path,
        read_toml_value(trimmed(text.substr(equals + 1)), place_.override_at, source_));
  }

 private:
  void set(Value::Table& document, std::string_view path, Value value) const {
    const std::size_t first_dot = path.find('.');
    if (first_dot == std::string_view::npos) return set_member(document, path, std::move(value));
    const std::size_t last_dot = path.rfind('.');
    const std::string_view head = path.substr(0, first_dot);
    const std::string_view key = path.substr(last_dot + 1);
    if (head.empty() || key.empty()) fail("the key has an empty part");
    if (first_dot == last_dot) return set_in_table(document, head, key, std::move(value));
    const std::string_view name = path.substr(first_dot + 1, last_dot - first_dot - 1);
    set_member(element(document, head, name), key, std::move(value));
  }

  void set_in_table(Value::Table& document,
                    std::string_view head,
                    std::string_view key,
                    Value value) const {
    Member* member = find_member(document, head);
    if (member == nullptr) {
      document.push_back({std::string(head), place_, {Value::Table{}, place_}});
      member = &document.back();
    }
    auto* table = std::get_if<Value::Table>(&member->value.data);
    if (table == nullptr) {
      fail(fmt::format("{0} is {1}; name the element, as in {0}.1.{2}", head,
                       describe_value(member->value), key));
    }
    set_member(*table, key, std::move(value));
  }

  [[nodiscard]] Value::Table& element(Value::Table& document,
                                      std::string_view kind,
                                      std::string_view name) const {
    Member* member = find_member(document, kind);
    auto* items = member == nullptr ? nullptr : std::get_if<Value::Array>(&member->value.data);
    if (items == nullptr) fail(fmt::format("the scene has no [[{}]]", kind));
    std::vector<std::string> names;
    for (std::size_t i = 0; i < items->size(); ++i) {
      names.push_back(element_name((*items)[i], kind, i));
    }
    const auto named = std::find(names.begin(), names.end(), name);
    std::size_t found = named - names.begin();
    if (named == names.end()) {
      std::size_t number = 0;
      const auto [stop, error] = std::from_chars(name.data(), name.data() + name.size(), number);
      const bool valid = error == std::errc() && stop == name.data() + name.size();
      if (!valid || number < 1 || number > items->size()) {
        fail(fmt::format("there is no {} \"{}\"{}", kind, name, suggestion(name, names)));
      }
      found = number - 1;
    }
    auto* table = std::get_if<Value::Table>(&(*items)[found].data);
    if (table == nullptr) fail(fmt::format("{}[{}] is not a table", kind, found + 1));
    return *table;
  }

  [[noreturn]] void fail(const std::string& message) const { source_.fail(place_, "", message); }

  Place place_;
  const SceneSource& source_;
};

}  // namespace

void apply_override(Value& document, int index, const SceneSource& source) {
  Override(index, source).apply(document);
}

}  // namespace wuerfel
