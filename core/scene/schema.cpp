#include <initializer_list>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/scene/entries.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {
namespace {

using Json = nlohmann::ordered_json;

Json number_schema(const Limits& limits) {
  return {{"type", "number"}, {"minimum", limits.min}, {"maximum", limits.max}};
}

Json array_schema(const Json& items, int size) {
  return {{"type", "array"}, {"items", items}, {"minItems", size}, {"maxItems", size}};
}

Json schema_of(const double& /*type*/, const Limits& limits) { return number_schema(limits); }
Json schema_of(const Vec2& /*type*/, const Limits& limits) {
  return array_schema(number_schema(limits), 2);
}
Json schema_of(const Region& /*type*/, const Limits& limits) {
  return array_schema(number_schema(limits), 4);
}
Json schema_of(const Size& /*type*/, const Limits& limits) {
  return {{"oneOf", Json::array({number_schema(limits), array_schema(number_schema(limits), 2)})}};
}
Json schema_of(const std::int64_t& /*type*/, const Limits& limits) {
  return {{"type", "integer"},
          {"minimum", static_cast<std::int64_t>(limits.min)},
          {"maximum", static_cast<std::int64_t>(limits.max)}};
}
Json schema_of(const std::string& /*type*/, const Limits& limits) {
  return {{"type", "string"},
          {"minLength", static_cast<int>(limits.min)},
          {"maxLength", static_cast<int>(limits.max)},
          {"pattern", "^[^\\u0000-\\u001f\\u007f]*$"}};
}
Json schema_of(const std::array<std::string, 2>& type, const Limits& limits) {
  return array_schema(schema_of(type[0], limits), 2);
}
template <class T>
requires std::is_enum_v<T> Json schema_of(const T& type, const Limits& /*limits*/) {
  return {{"type", "string"}, {"enum", choices(type)}};
}
Json schema_of(const bool& /*type*/, const Limits& /*limits*/) { return {{"type", "boolean"}}; }
Json schema_of(const PlaceEntry& /*type*/, const Limits& limits) {
  Json body = schema_of(std::string(), limits::name);
  body["description"] = "Name of a body";
  const Json place = schema_of(Vec2{}, limits);
  Json at = place;
  at["description"] = "m, from its centre, in the frame of the unturned body";
  const Json in_frame = {{"type", "object"},
                         {"additionalProperties", false},
                         {"properties", {{"body", std::move(body)}, {"at", std::move(at)}}},
                         {"required", {"body", "at"}}};
  return {{"oneOf", Json::array({schema_of(std::string(), limits::place), place, in_frame})}};
}
Json schema_of(const Rgb& /*type*/, const Limits& /*limits*/) {
  Json names = Json::array();
  for (const NamedColor& color : okabe_ito()) {
    names.push_back(color.name);
  }
  return {
      {"type", "string"},
      {"anyOf", Json::array({{{"pattern", "^#[0-9a-fA-F]{6}$"}}, {{"enum", std::move(names)}}})}};
}
template <class T>
Json schema_of(const std::optional<T>& /*type*/, const Limits& limits) {
  return schema_of(T{}, limits);
}

/// A key's default as JSON; null where it is the absence of the key.
Json default_of(double value) { return value; }
Json default_of(bool value) { return value; }
Json default_of(std::int64_t value) { return value; }
Json default_of(const std::string& value) { return value; }
Json default_of(const Vec2& value) { return {value.x(), value.y()}; }
Json default_of(const Size& value) { return value.extent.x(); }
template <class T>
requires std::is_enum_v<T> Json default_of(T value) {
  return choices(value)[static_cast<int>(value)];
}
template <class T>
Json default_of(const std::optional<T>& /*value*/) {
  return nullptr;
}

/// Visitor of `describe`: writes what the entry's keys are as a JSON Schema.
class SchemaWriter {
 public:
  template <class T>
  void value(std::string_view key, const T& target, const Limits& limits, std::string_view doc) {
    Json schema = schema_of(target, limits);
    schema["description"] = doc;
    const Json standard = default_of(target);
    if (!standard.is_null()) schema["default"] = standard;
    properties_[std::string(key)] = std::move(schema);
  }

  template <class T>
  void value(std::string_view key, const T& target, std::string_view doc) {
    value(key, target, Limits{}, doc);
  }

  template <class T>
  void required(std::string_view key, const T& target, const Limits& limits, std::string_view doc) {
    Json schema = schema_of(target, limits);
    schema["description"] = doc;
    properties_[std::string(key)] = std::move(schema);
    required_.push_back(key);
  }

  template <class Entry>
  void table(std::string_view key, Entry& entry, std::string_view doc) {
    SchemaWriter writer;
    describe(writer, entry);
    Json schema = writer.take();
    schema["description"] = doc;
    properties_[std::string(key)] = std::move(schema);
  }

  template <class Entry>
  void tables(std::string_view key, const std::vector<Entry>& /*entries*/, std::string_view doc) {
    SchemaWriter writer;
    Entry entry;
    describe(writer, entry);
    properties_[std::string(key)] = {
        {"description", doc}, {"type", "array"}, {"items", writer.take()}};
  }

  void exactly_one(std::initializer_list<std::string_view> keys) {
    rules_.push_back({{"oneOf", each_required(keys)}});
  }
  void at_least_one(std::initializer_list<std::string_view> keys) {
    rules_.push_back({{"anyOf", each_required(keys)}});
  }
  /// No two of them.
  void at_most_one(std::initializer_list<std::string_view> keys) {
    const std::vector<std::string_view> list(keys);
    Json pairs = Json::array();
    for (std::size_t i = 0; i < list.size(); ++i) {
      for (std::size_t j = i + 1; j < list.size(); ++j) {
        pairs.push_back({{"required", {list[i], list[j]}}});
      }
    }
    rules_.push_back({{"not", {{"anyOf", std::move(pairs)}}}});
  }
  void needs(std::string_view key, std::string_view other) {
    dependencies_[std::string(key)] = Json::array({other});
  }

  Json take() {
    Json schema = {{"type", "object"},
                   {"additionalProperties", false},
                   {"properties", std::move(properties_)}};
    if (!required_.empty()) schema["required"] = std::move(required_);
    if (!dependencies_.empty()) schema["dependencies"] = std::move(dependencies_);
    if (!rules_.empty()) schema["allOf"] = std::move(rules_);
    return schema;
  }

 private:
  static Json each_required(std::initializer_list<std::string_view> keys) {
    Json list = Json::array();
    for (const std::string_view key : keys) {
      list.push_back({{"required", Json::array({key})}});
    }
    return list;
  }

  Json properties_ = Json::object();
  Json required_ = Json::array();
  Json dependencies_ = Json::object();
  Json rules_ = Json::array();
};

}  // namespace

std::string scene_schema() {
  SchemaWriter writer;
  SceneEntries entries;
  describe(writer, entries);
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                 {"title", "wuerfel scene"},
                 {"description",
                  "A scene of falling cubes; TOML and JSON have the same keys. SI units, y up."}};
  schema.update(writer.take());
  return schema.dump(2) + "\n";
}

}  // namespace wuerfel
