/// One command on several scenes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/cli/exit_code.h"
#include "app/cli/scene_source.h"

namespace wuerfel {

/// How a scene is answered where it may be one of several.
struct Answer {
  ExitCode code = ExitCode::fine;
  std::string text;  ///< for people, or as JSON
};

/// Whether an answer is JSON, and on one line since others follow.
struct AnswerForm {
  bool json = false;
  bool one_line = false;
};

/// Answers one scene after the other on standard output. Where there are several, one that fails is
/// answered by what went wrong, {"error": ..} as JSON, and the others go on. The largest exit code;
/// throws what the only scene throws, and OutputError.
ExitCode for_each_scene(const std::vector<std::string>& sources,
                        bool json,
                        const std::function<Answer(const SceneText&, AnswerForm)>& answer);

/// As text that ends its line: on one line, or indented.
std::string json_text(const nlohmann::ordered_json& json, AnswerForm form);

}  // namespace wuerfel
