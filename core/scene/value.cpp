#include "core/scene/value.h"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include "core/scene/scene_parser.h"

namespace wuerfel {
namespace {

/// Long texts are cut: a message is one line.
constexpr std::size_t longest_quote = 60;

struct Describer {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
  std::string operator()(double value) const { return fmt::format("{}", value); }
  std::string operator()(const std::string& text) const {
    return text.size() <= longest_quote ? fmt::format("text (\"{}\")", text) : "a long text";
  }
  std::string operator()(const Value::Array& items) const {
    return fmt::format("an array of {}", items.size());
  }
  std::string operator()(const Value::Table&) const { return "a table"; }
  std::string operator()(const ForeignValue& value) const { return std::string(value.kind); }
};

/// What is quoted from the text may hold line breaks or terminal commands; a message is one
/// harmless line.
std::string without_control_characters(const std::string& message) {
  std::string clean;
  for (const char c : message) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20U || code == 0x7fU) {
      clean += fmt::format("\\x{:02x}", code);
    } else {
      clean += c;
    }
  }
  return clean;
}

}  // namespace

bool written_before(const Place& a, const Place& b) {
  return std::tie(a.override_at, a.line, a.column) < std::tie(b.override_at, b.line, b.column);
}

const Member* find_member(const Value::Table& table, std::string_view key) {
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const Member& m) { return m.key == key; });
  return found == table.end() ? nullptr : &*found;
}

std::string describe_value(const Value& value) { return std::visit(Describer{}, value.data); }

void SceneSource::fail(const Place& place,
                       const std::string& path,
                       const std::string& message) const {
  std::string where = name;
  if (place.override_at >= 0) {
    const std::string origin = origins.empty() ? "--set " : origins[place.override_at] + ": ";
    where = origin + overrides[place.override_at];
  } else if (place.line > 0) {
    where += fmt::format(":{}:{}", place.line, place.column);
  }
  const std::string text = where + ": " + (path.empty() ? "" : path + ": ") + message;
  throw SceneError(without_control_characters(text));
}

}  // namespace wuerfel
