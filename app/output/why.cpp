#include "app/output/why.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "app/output/json_values.h"
#include "app/words/naming.h"

namespace wuerfel {

namespace {

using Json = nlohmann::ordered_json;

Json cause_json(const StillScene& still, const Cause& cause) {
  return {{"part", names_of(still, cause.part.cubes)},
          {"on", names_of(still, cause.on)},
          {"corner", vector_json(cause.corner)},
          {"outside", cause.outside ? Json(*cause.outside) : Json(nullptr)}};
}

Json part_json(const StillScene& still, const MovingPart& part) {
  return {{"part", names_of(still, part.cubes)},
          {"turn", part.turn > 0   ? "left"
                   : part.turn < 0 ? "right"
                                   : "none"},
          {"pivot", vector_json(part.pivot)},
          {"opens", names_of(still, part.opens)},
          {"work_share", part.work_share}};
}

Json fix_json(const StillScene& still, const Fix& fix) {
  const bool move = fix.kind == Fix::Kind::move;
  return {{"kind", move ? "move" : "force"},
          {"body", still.system.body(fix.cube).name},
          {"point", vector_json(fix.point)},
          {"force", move ? Json(nullptr) : vector_json(fix.force)},
          {"distance", move ? Json(fix.distance) : Json(nullptr)},
          {"verified", to_string(fix.verified)}};
}

template <typename Item>
Json list_json(const Explanation& e,
               const std::vector<Item>& items,
               Json (*of)(const StillScene&, const Item&)) {
  Json list = Json::array();
  for (const Item& item : items)
    list.push_back(of(*e.still, item));
  return list;
}

}  // namespace

Json why_json(const Explanation& e, const std::vector<std::string>& text) {
  Json json{{"verdict", to_string(e.check.verdict)}, {"certificate", nullptr}};
  if (!e.causes.certificate.motion.empty()) {
    json["certificate"] = {{"power", e.causes.certificate.power},
                           {"worst_closing", e.causes.certificate.worst_closing}};
  }
  json["causes"] = list_json(e, e.causes.causes, cause_json);
  json["mechanism"] = list_json(e, e.causes.mechanism, part_json);
  json["fixes"] = list_json(e, e.fixes, fix_json);
  json["text"] = text;
  if (e.check.facts) {
    json["facts"] = {{"equilibrium_exists", e.check.facts->equilibrium_exists},
                     {"acceleration_zero", e.check.verdict == Verdict::stands}};
  }
  return json;
}

}  // namespace wuerfel
