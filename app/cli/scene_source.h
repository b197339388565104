/// Where scenes come from: a file, standard input, or the scenes that come along.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace wuerfel {

struct SceneChoice {
  std::string source;  ///< path, `-` for standard input, or the name of a shipped scene
  std::vector<std::string> overrides;  ///< key=value
};

/// Throws SceneError. Notes on stderr what the scene asks for and the program does not compute.
Scene read_scene(const SceneChoice& choice);

/// 64-bit FNV-1a of the text in hexadecimal: names a scene in summaries.
std::string text_hash(std::string_view text);

}  // namespace wuerfel
