#include <fmt/core.h>

#include "app/commands.h"
#include "app/shipped_scenes.h"
#include "app/text_output.h"
#include "core/scene/scene_parser.h"
#include "core/scene/suggestion.h"

namespace wuerfel {

namespace {

std::string list_of_scenes() {
  std::string list;
  for (const ShippedScene& shipped : shipped_scenes()) {
    const Scene scene = parse_scene(std::string(shipped.text), std::string(shipped.name));
    list += fmt::format("{:<22} {}\n", shipped.name, scene.title);
  }
  return list;
}

}  // namespace

ExitCode scenes(const std::string& name) {
  if (name.empty()) {
    write_text("-", list_of_scenes());
    return ExitCode::fine;
  }
  if (const ShippedScene* scene = find_shipped_scene(name)) {
    write_text("-", scene->text);
    return ExitCode::fine;
  }
  std::vector<std::string_view> names;
  for (const ShippedScene& scene : shipped_scenes())
    names.push_back(scene.name);
  throw UsageError(fmt::format("there is no scene '{}'{}", name, suggestion(name, names)));
}

}  // namespace wuerfel
