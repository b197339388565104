/// Text -> Scene. TOML for people, JSON with the same keys for programs.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace wuerfel {

/// Bad input. The message says where, what is wrong and what would be right:
///   stack.toml:7:8: cube[2].size: must be greater than 0; it is -1       (TOML: line and column)
///   stack.json: cube[2].size: must be greater than 0; it is -1           (JSON: the key path;
///   syntax errors have both)
///   --set cube.b.size=-1: cube[2].size: must be greater than 0; it is -1
/// Elements of arrays are counted from 1, like the names of unnamed bodies (cube1, cube2, ...).
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Bodies overlap.
class OverlapError : public SceneError {
 public:
  using SceneError::SceneError;
};

/// Reads a scene from text. JSON if the first character that is not white space is '{' (or `name`
/// ends in ".json"), else TOML. `name` stands for the file in messages; `overrides` are "KEY=VALUE"
/// texts as in `--set cube.a.angle=0.1`, applied in their order before anything is checked (see
/// override.h for the forms of KEY); `origins` say where each was written, if not there. The result has every generator and placement resolved and
/// nothing that overlaps. Throws SceneError.
Scene parse_scene(std::string_view text,
                  const std::string& name,
                  const std::vector<std::string>& overrides = {},
                  const std::vector<std::string>& origins = {});

/// The scene written back as JSON of the contract, on one line: every number with the fewest digits
/// that bring back the same double, keys in a fixed order, friction and restitution of a body only
/// where they differ from the scene's material. parse_scene of it gives an equal scene.
std::string normalised_scene(const Scene& scene);

/// JSON Schema (draft 7) of the scene format; the same for TOML and JSON.
std::string scene_schema();

}  // namespace wuerfel
