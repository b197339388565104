/// Scenes as Python has them: what was read, and how it was written, so that keys can be changed.
#pragma once

#include <map>
#include <pybind11/pybind11.h>
#include <string>
#include <vector>

#include "app/cli/scene_source.h"
#include "core/scene/scene.h"

namespace wuerfel::python {

struct PyScene {
  SceneText text;
  std::vector<std::string> overrides;  ///< KEY=VALUE, after one another
  Scene scene;

  /// The scene with these keys set, too, as --set does.
  [[nodiscard]] PyScene with(const pybind11::kwargs& keys) const;
  /// As the program would write it: JSON with all generators and placements resolved.
  [[nodiscard]] std::string json() const;
  [[nodiscard]] std::vector<std::string> names() const;
};

/// From a path, TOML or JSON text, a dict, the name of a shipped scene, or a scene.
PyScene load_scene(const pybind11::object& source);

void bind_scene(pybind11::module_& module);

}  // namespace wuerfel::python
