/// Reads a table of the tree into an entry, guided by the entry's `describe`.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/spot.h"

namespace wuerfel {

/// Visitor of `describe`. Values are read at once; what depends on all keys of the table (unknown
/// and missing keys, alternatives) is judged in finish(), unknown keys first, since a misspelt key
/// is also a missing one.
class TableReader {
 public:
  /// Throws SceneError where `value` is no table. `path` names it in messages, empty for the
  /// document.
  TableReader(const SceneSource& source, const Value& value, std::string path);

  template <class T>
  void value(std::string_view key, T& target, const Limits& limits, std::string_view /*doc*/) {
    known_.push_back(key);
    const Member* member = find_member(*table_, key);
    if (member != nullptr) read({source_, member->value, path_, key}, limits, target);
  }

  template <class T>
  void value(std::string_view key, T& target, std::string_view doc) {
    value(key, target, Limits{}, doc);
  }

  template <class T>
  void required(std::string_view key, T& target, const Limits& limits, std::string_view doc) {
    required_.push_back(key);
    value(key, target, limits, doc);
  }

  template <class Entry>
  void table(std::string_view key, Entry& entry, std::string_view /*doc*/) {
    known_.push_back(key);
    const Member* member = find_member(*table_, key);
    if (member == nullptr) return;
    TableReader reader(source_, member->value, inner_path(key));
    describe(reader, entry);
    reader.finish();
  }

  template <class Entry>
  void tables(std::string_view key, std::vector<Entry>& entries, std::string_view /*doc*/) {
    known_.push_back(key);
    const Member* member = find_member(*table_, key);
    if (member == nullptr) return;
    const Value::Array& items = tables_of(*member);
    entries.resize(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
      Entry& entry = entries[i];
      entry.origin = {&items[i], element_path(key, i)};
      TableReader reader(source_, items[i], entry.origin.path);
      describe(reader, entry);
      reader.finish();
    }
  }

  void exactly_one(std::initializer_list<std::string_view> keys) { add_rule(keys, true, true); }
  void at_most_one(std::initializer_list<std::string_view> keys) { add_rule(keys, false, true); }
  void at_least_one(std::initializer_list<std::string_view> keys) { add_rule(keys, true, false); }
  void needs(std::string_view key, std::string_view other) { needs_.push_back({key, other}); }

  /// Throws SceneError where the keys present break a rule.
  void finish() const;

 private:
  struct Alternatives {
    std::vector<std::string_view> keys;
    bool one_needed = false;
    bool one_allowed = false;
  };
  struct Need {
    std::string_view key;
    std::string_view other;
  };

  void add_rule(std::initializer_list<std::string_view> keys, bool one_needed, bool one_allowed) {
    alternatives_.push_back({keys, one_needed, one_allowed});
  }
  [[nodiscard]] const Value::Array& tables_of(const Member& member) const;
  [[nodiscard]] std::string inner_path(std::string_view key) const;
  static std::string element_path(std::string_view key, std::size_t index);
  void refuse_unknown_keys() const;
  void judge(const Alternatives& rule) const;
  [[noreturn]] void fail(const Place& place,
                         std::string_view key,
                         const std::string& message) const;

  const SceneSource& source_;
  const Value& value_;
  const Value::Table* table_ = nullptr;
  std::string path_;
  std::vector<std::string_view> known_;
  std::vector<std::string_view> required_;
  std::vector<Alternatives> alternatives_;
  std::vector<Need> needs_;
};

}  // namespace wuerfel
