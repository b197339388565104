#include "app/sweep/sample.h"

#include <numeric>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/sweep/sample_run.h"
#include "app/sweep/statics.h"
#include "core/scene/json_string.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Label& label) {
  return std::visit(
      [](const auto& value) -> Json {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>) {
          return nullptr;
        } else {
          return value;
        }
      },
      label);
}

template <class Items, class Write>
std::string joined(const Items& items, const Write& write) {
  std::string text;
  for (const auto& item : items)
    text += (text.empty() ? "" : ",") + write(item);
  return text;
}

std::string labels_json(const Sweep& sweep,
                        const Case& one,
                        const Scene& scene,
                        const LabelRow& row) {
  const std::string labels = joined(row, [](const auto& label) {
    return json_string(label.first) + ':' + json_of(label.second).dump();
  });
  std::vector<int> bodies(scene.cubes.size() + scene.points.size());
  std::iota(bodies.begin(), bodies.end(), 0);
  const std::string names =
      joined(bodies, [&](int body) { return json_string(moving_name(scene, body)); });
  return fmt::format(
      R"({{"id":"{}","case":{},"split":{},"values":{},"labels":{{{}}},"bodies":[{}],"scene":{}}})"
      "\n",
      one.id, one.number, json_string(one.split), values_json(sweep, one), labels, names,
      normalised_scene(scene));
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
