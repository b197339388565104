#include "app/sweep/sample.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/sweep/sample_run.h"
#include "app/sweep/statics.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Label& label) {
  return std::visit(
      [](const auto& value) -> Json {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>)
          return nullptr;
        else
          return value;
      },
      label);
}

std::string labels_json(const Sweep& sweep,
                        const Case& one,
                        const Scene& scene,
                        const LabelRow& row) {
  Json values = Json::object();
  for (std::size_t v = 0; v < one.values.size(); ++v)
    values[sweep.variables[v].key] = Json::parse(one.values[v]);
  Json labels = Json::object();
  for (const auto& [name, label] : row)
    labels[name] = json_of(label);
  Json bodies = Json::array();
  for (std::size_t i = 0; i < scene.cubes.size() + scene.points.size(); ++i)
    bodies.push_back(moving_name(scene, static_cast<int>(i)));
  const Json head{{"id", one.id},
                  {"case", one.number},
                  {"split", one.split},
                  {"values", std::move(values)},
                  {"labels", std::move(labels)},
                  {"bodies", std::move(bodies)}};
  const std::string text = head.dump();
  return text.substr(0, text.size() - 1) + ",\"scene\":" + normalised_scene(scene) + "}\n";
}

}  // namespace

void SampleMaker::prepare() {
  if (sweep_.files.pictures()) renderers_.mine();
}

std::vector<TapeFile> SampleMaker::files(const Case& one) {
  const Scene scene = scene_of(sweep_, one.values);
  Statics statics(scene);
  LabelRow row = statics.labels(sweep_.labels.check);
  SampleRun run(sweep_, scene, stop_);
  if (sweep_.files.pictures()) run.draw_with(renderers_.mine());
  if (sweep_.files.violation_mask) run.mark(statics.violations());
  run.go();
  for (auto& label : run.labels())
    row.push_back(std::move(label));
  std::vector<TapeFile> files{{one.id + ".json", labels_json(sweep_, one, scene, row)}};
  for (TapeFile& file : run.files())
    files.push_back({one.id + file.name, std::move(file.bytes)});
  return files;
}

}  // namespace wuerfel
