#include "app/sweep/value_json.h"

namespace wuerfel {

namespace {

using Json = nlohmann::ordered_json;

struct ToJson {
  Json operator()(const Value::Array& items) const {
    Json json = Json::array();
    for (const Value& item : items)
      json.push_back(json_of(item));
    return json;
  }
  Json operator()(const Value::Table& table) const {
    Json json = Json::object();
    for (const Member& member : table)
      json[member.key] = json_of(member.value);
    return json;
  }
  Json operator()(const ForeignValue& /*value*/) const { return nullptr; }
  template <class Plain>
  Json operator()(const Plain& value) const {
    return value;
  }
};

}  // namespace

nlohmann::ordered_json json_of(const Value& value) { return std::visit(ToJson{}, value.data); }

}  // namespace wuerfel
