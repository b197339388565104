/// The scenes of assets/scenes, built into the program.
#pragma once

#include <span>
#include <string_view>

namespace wuerfel {

struct ShippedScene {
  std::string_view name;  ///< file name without suffix
  std::string_view text;  ///< TOML
};

/// In alphabetical order.
std::span<const ShippedScene> shipped_scenes();

/// Null where there is none of that name.
const ShippedScene* find_shipped_scene(std::string_view name);

}  // namespace wuerfel
