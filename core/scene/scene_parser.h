/// Text -> Scene. TOML for people, JSON with the same keys for programs.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace wuerfel {

/// Bad input: the message names file:line:column (TOML), key or body, what is wrong and what would be right.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads a scene from text. JSON if the first character that is not white space is '{' or '[', else TOML.
/// `name` stands for the file in messages; `overrides` are "key=value" texts as in `--set cube.a.angle=0.1`.
/// Throws SceneError.
Scene parse_scene(std::string_view text,
                  const std::string& name,
                  const std::vector<std::string>& overrides = {});

/// The scene written back as JSON of the contract: generators and placements resolved, every number with the
/// digits that bring back the same double, keys in a fixed order. parse_scene of it gives an equal scene.
std::string normalised_scene(const Scene& scene);

/// JSON Schema (draft 7) of the scene format; the same for TOML and JSON.
std::string scene_schema();

}  // namespace wuerfel
