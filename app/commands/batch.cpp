#include "app/commands/batch.h"

#include <algorithm>
#include <optional>

#include <nlohmann/json.hpp>

#include "app/cli/failure.h"
#include "app/output/text_output.h"
#include "render/error.h"

namespace wuerfel {

namespace {

Answer told(const Failure& failure, AnswerForm form) {
  if (!form.json) {
    complain(failure.message);
    return {failure.code, ""};
  }
  return {failure.code, json_text({{"error", failure.message}}, form)};
}

}  // namespace

ExitCode for_each_scene(const std::vector<std::string>& sources,
                        bool json,
                        const std::function<Answer(const SceneText&, AnswerForm)>& answer) {
  SceneQueue queue(sources);
  ExitCode worst = ExitCode::fine;
  for (bool more = true; more;) {
    Answer next;
    try {
      const std::optional<SceneText> text = queue.next();
      more = text.has_value();
      if (more) next = answer(*text, {json, queue.several()});
    } catch (const OutputError&) {
      throw;
    } catch (const std::exception&) {
      if (!queue.several()) throw;
      next = told(failure_of(std::current_exception()), {json, true});
    }
    if (!next.text.empty()) write_text("-", next.text);
    worst = std::max(worst, next.code);
  }
  return worst;
}

std::string json_text(const nlohmann::ordered_json& json, AnswerForm form) {
  return json.dump(form.one_line ? -1 : 2) + "\n";
}

}  // namespace wuerfel
