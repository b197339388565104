#include "tests/unit/scene/scene_texts.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

namespace wuerfel::test {
namespace {

std::string error_of(const std::string& text,
                     const std::string& name,
                     const std::vector<std::string>& overrides) {
  try {
    parse_scene(text, name, overrides);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

std::vector<std::string> shipped_scene_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(SCENES)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string shipped_scene_text(const std::string& name) {
  std::ifstream file(std::string(SCENES) + "/" + name + ".toml", std::ios::binary);
  EXPECT_TRUE(file.good()) << name;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string toml_error(const std::string& text, const std::vector<std::string>& overrides) {
  return error_of(text, "s.toml", overrides);
}

std::string json_error(const std::string& text, const std::vector<std::string>& overrides) {
  return error_of(text, "s.json", overrides);
}

SceneCube cube_named(const Scene& scene, const std::string& name) {
  const auto found = std::find_if(scene.cubes.begin(), scene.cubes.end(),
                                  [&](const SceneCube& cube) { return cube.name == name; });
  if (found != scene.cubes.end()) return *found;
  ADD_FAILURE() << "no cube " << name;
  return {};
}

}  // namespace wuerfel::test
