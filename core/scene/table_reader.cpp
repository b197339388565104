#include "core/scene/table_reader.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/scene/suggestion.h"

namespace wuerfel {

TableReader::TableReader(const SceneSource& source, const Value& value, std::string path)
    : source_(source),
      value_(value),
      table_(std::get_if<Value::Table>(&value.data)),
      path_(std::move(path)) {
  if (table_ == nullptr) {
    source.fail(value.place, path_,
                fmt::format("{} be a table, not {}", path_.empty() ? "a scene must" : "must",
                            describe_value(value)));
  }
}

std::string TableReader::inner_path(std::string_view key) const {
  return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

std::string TableReader::element_path(std::string_view key, std::size_t index) {
  return fmt::format("{}[{}]", key, index + 1);
}

const Value::Array& TableReader::tables_of(const Member& member) const {
  const auto* items = std::get_if<Value::Array>(&member.value.data);
  if (items == nullptr) {
    source_.fail(member.place, member.key,
                 fmt::format("must be an array of tables ([[{}]] in TOML), not {}", member.key,
                             describe_value(member.value)));
  }
  return *items;
}

void TableReader::fail(const Place& place, std::string_view key, const std::string& message) const {
  std::string path = path_;
  if (!key.empty()) path += path_.empty() ? std::string(key) : fmt::format(".{}", key);
  source_.fail(place, path, message);
}

void TableReader::refuse_unknown_keys() const {
  for (const Member& member : *table_) {
    if (std::find(known_.begin(), known_.end(), member.key) == known_.end()) {
      fail(member.place, "",
           fmt::format("unknown key \"{}\"{}", member.key, suggestion(member.key, known_)));
    }
    if (find_member(*table_, member.key) != &member) {
      fail(member.place, member.key, "given twice");
    }
  }
}

void TableReader::judge(const Alternatives& rule) const {
  std::vector<const Member*> present;
  for (const std::string_view key : rule.keys) {
    if (const Member* member = find_member(*table_, key)) present.push_back(member);
  }
  if (rule.one_needed && present.empty()) {
    fail(value_.place, "",
         fmt::format("{}needs {}", path_.empty() ? "a scene " : "", fmt::join(rule.keys, " or ")));
  }
  if (rule.one_allowed && present.size() > 1) {
    std::stable_sort(present.begin(), present.end(), [](const Member* a, const Member* b) {
      return written_before(a->place, b->place);
    });
    fail(present[1]->place, present[1]->key,
         fmt::format("cannot be given together with {}", present[0]->key));
  }
}

void TableReader::finish() const {
  refuse_unknown_keys();
  for (const std::string_view key : required_) {
    if (find_member(*table_, key) == nullptr) fail(value_.place, "", fmt::format("needs {}", key));
  }
  for (const Alternatives& rule : alternatives_) {
    judge(rule);
  }
  for (const Need& need : needs_) {
    const Member* member = find_member(*table_, need.key);
    if (member != nullptr && find_member(*table_, need.other) == nullptr) {
      fail(member->place, need.key, fmt::format("is of use only together with {}", need.other));
    }
  }
}

}  // namespace wuerfel
