/// One command on several scenes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/cli/exit_code.h"
#include "app/cli/scene_source.h"
#include "app/cli/streams.h"

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

/// The scenes of a command and how they are answered.
struct Batch {
  std::vector<std::string> sources;
  bool json = false;
  bool quiet = false;  ///< no notes
  int threads = 0;     ///< that answer several scenes at once; 0: one per core
};

using AnswerScene = std::function<Answer(const SceneText&, AnswerForm, Notes&)>;

/// Answers the scenes on standard output in their order, several at once where there are threads:
/// the same text for any number of them. Where there are several scenes, one that fails is answered
/// by what went wrong, {"error": ..} as JSON, and the others go on. The largest exit code; throws
/// what the only scene throws, OutputError and Interrupted.
ExitCode for_each_scene(const Batch& batch, const AnswerScene& answer);

/// As text that ends its line: on one line, or indented.
std::string json_text(const nlohmann::ordered_json& json, AnswerForm form);

}  // namespace wuerfel
