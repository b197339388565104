/// Names of the files of a plan.
#pragma once

#include <string>
#include <string_view>

#include "core/scene/scene_text.h"

namespace wuerfel {

inline constexpr int plan_format = 1;
inline constexpr const char* plan_name = "plan.json";
inline constexpr const char* manifest_name = "manifest.jsonl";
inline constexpr const char* shards_folder = "shards";

/// "sweep.toml" or "sweep.json", by the text.
inline std::string plan_file_name(const std::string& what, std::string_view text) {
  return what + (language_of(text, "") == SceneLanguage::json ? ".json" : ".toml");
}

}  // namespace wuerfel
