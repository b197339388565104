/// Value: what stands in a scene text, whichever language it was written in, with the place where
/// it stands.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace wuerfel {

/// Where something was written. TOML knows line and column (1-based), JSON values are found by
/// their key path alone, and what came from an override is named by the override's text.
struct Place {
  int line = 0;          ///< 0: not known
  int column = 0;        ///< in characters
  int override_at = -1;  ///< index of the override, -1: from the text
};

/// Whether `a` was written before `b`: text in reading order, then overrides.
bool written_before(const Place& a, const Place& b);

/// A value that TOML has and scenes do not (dates and times), by its name.
struct ForeignValue {
  std::string_view kind;
};

struct Member;

struct Value {
  using Array = std::vector<Value>;
  using Table = std::vector<Member>;
  std::variant<bool, std::int64_t, double, std::string, Array, Table, ForeignValue> data;
  Place place;
};

struct Member {
  std::string key;
  Place place;  ///< of the key
  Value value;
};

/// First member with this key, or null.
const Member* find_member(const Value::Table& table, std::string_view key);

/// The value as a message quotes it: its kind and, where short, itself, as in `text ("abc")` or `a
/// table`.
std::string describe_value(const Value& value);

/// The text a scene is read from, as messages name it.
struct SceneSource {
  std::string name;
  std::vector<std::string> overrides;
  std::vector<std::string> origins{};  ///< of the overrides; empty: the command line

  /// Throws SceneError "NAME:LINE:COLUMN: PATH: MESSAGE", without what is not known; "--set
  /// OVERRIDE: ...", or "ORIGIN: OVERRIDE: ...", where the place is in an override. One line: control characters that are quoted
  /// come as \x0a.
  [[noreturn]] void fail(const Place& place,
                         const std::string& path,
                         const std::string& message) const;
};

}  // namespace wuerfel
