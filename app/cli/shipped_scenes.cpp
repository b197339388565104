#include "app/cli/shipped_scenes.h"

#include <algorithm>

namespace wuerfel {

const ShippedScene* find_shipped_scene(std::string_view name) {
  const std::span<const ShippedScene> scenes = shipped_scenes();
  const auto found = std::ranges::find(scenes, name, &ShippedScene::name);
  return found == scenes.end() ? nullptr : &*found;
}

}  // namespace wuerfel
