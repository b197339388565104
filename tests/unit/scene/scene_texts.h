/// Texts that the scene tests read, and what the reader says of them.
#pragma once

#include <string>
#include <vector>

#include "core/scene/scene_parser.h"

namespace wuerfel::test {

/// A cube, to which a third line adds a mistake.
inline constexpr const char* cube_text = "[[cube]]\nposition = [0, 1]\n";

/// Names of the files in assets/scenes without folder and ".toml", sorted.
std::vector<std::string> shipped_scene_names();

/// Text of assets/scenes/NAME.toml.
std::string shipped_scene_text(const std::string& name);

/// The message with which parse_scene refuses `text`, called s.toml or s.json; "no error" where it
/// does not.
std::string toml_error(const std::string& text, const std::vector<std::string>& overrides = {});
std::string json_error(const std::string& text, const std::vector<std::string>& overrides = {});

/// The cube called `name`; the test fails and a cube without name comes back where there is none.
SceneCube cube_named(const Scene& scene, const std::string& name);

}  // namespace wuerfel::test
