/// A case of a plan: its number, its name, where it belongs, and the values that make its scene.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/sweep/sweep_file.h"
#include "core/scene/scene.h"

namespace wuerfel {

struct Case {
  long number = 0;
  std::string id;                   ///< 16 hexadecimal digits
  std::string split;                ///< train, validation, test or test_ood
  std::vector<std::string> values;  ///< one per variable, as TOML and JSON write them
};

/// The scene of these values. Throws SceneError, OverlapError where bodies overlap.
Scene scene_of(const Sweep& sweep, const std::vector<std::string>& values);

/// The name of a case: a hash of the scene itself and of the sweep's name.
std::string case_id(const Sweep& sweep, const Scene& scene);

/// Where a case belongs: by its name, or by values that are held out. Stays when cases are added.
std::string split_of(const Sweep& sweep, const Case& one);

/// The values of a case by their keys, as a JSON object.
std::string values_json(const Sweep& sweep, const Case& one);

/// One line of the manifest, without its end; and back. Throws UsageError on what is none.
std::string line_of(const Sweep& sweep, const Case& one);
Case case_of(const Sweep& sweep, std::string_view line);

}  // namespace wuerfel
