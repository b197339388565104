#include <memory>

#include <fmt/core.h>

#include "app/cli/shipped_scenes.h"
#include "app/commands/commands.h"
#include "app/output/text_output.h"
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

ExitCode scenes(const std::string& name) {
  if (name.empty()) {
    write_text("-", list_of_scenes());
    return ExitCode::fine;
  }
  if (const ShippedScene* scene = find_shipped_scene(name)) {
    write_text("-", scene->text);
    return ExitCode::fine;
  }
  throw UsageError(fmt::format("there is no scene '{}'{}", name,
                               suggestion(name, shipped_scenes(), &ShippedScene::name)));
}

}  // namespace

Action declare_scenes(Options& options) {
  auto name = std::make_shared<std::string>();
  options.optional_argument("NAME", "scene to print", *name);
  return [name](const Stopwatch&) { return scenes(*name); };
}

}  // namespace wuerfel
