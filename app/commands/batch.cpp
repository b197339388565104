#include "app/commands/batch.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/cli/failure.h"
#include "app/output/text_output.h"
#include "core/check_many.h"
#include "render/error.h"

namespace wuerfel {

namespace {

/// What is said of one of several scenes when its turn has come.
struct Reply {
  Answer answer;
  std::vector<std::string> notes;
  std::string complaint;
};

Reply reply_to_failure(const Failure& failure, bool json) {
  Reply reply;
  reply.answer.code = failure.code;
  if (json) {
    reply.answer.text = json_text({{"error", failure.message}}, {true, true});
  } else {
    reply.complaint = failure.message;
  }
  return reply;
}

Reply reply_to(const Batch& batch, const AnswerScene& answer, const Attempt<SceneText>& scene) {
  try {
    if (scene.failure != nullptr) std::rethrow_exception(scene.failure);
    Notes notes(batch.quiet ? Notes::Voice::quiet : Notes::Voice::later);
    Answer found = answer(scene.answer, {batch.json, true}, notes);
    return {std::move(found), notes.unsaid(), ""};
  } catch (const OutputError&) {
    throw;
  } catch (const std::exception&) {
    return reply_to_failure(failure_of(std::current_exception()), batch.json);
  }
}

void deliver(const Reply& reply) {
  for (const std::string& note : reply.notes)
    say(note);
  if (!reply.complaint.empty()) complain(reply.complaint);
  if (!reply.answer.text.empty()) write_text("-", reply.answer.text);
}

// The next scene or why it cannot be read; nothing behind the last.
std::optional<Attempt<SceneText>> fetch(SceneQueue& queue) {
  Attempt<std::optional<SceneText>> next = attempt([&] { return queue.next(); });
  if (next.failure == nullptr && !next.answer) return std::nullopt;
  return Attempt<SceneText>{std::move(next.answer).value_or(SceneText{}), next.failure};
}

ExitCode answer_alone(const Batch& batch,
                      const AnswerScene& answer,
                      const Attempt<SceneText>& scene) {
  if (scene.failure != nullptr) std::rethrow_exception(scene.failure);
  Notes notes(batch.quiet ? Notes::Voice::quiet : Notes::Voice::at_once);
  const Answer found = answer(scene.answer, {batch.json, false}, notes);
  if (!found.text.empty()) write_text("-", found.text);
  return found.code;
}

}  // namespace

ExitCode for_each_scene(const Batch& batch, const AnswerScene& answer) {
  SceneQueue queue(batch.sources);
  std::optional<Attempt<SceneText>> first = fetch(queue);
  if (!first) return ExitCode::fine;
  if (!queue.several()) return answer_alone(batch, answer, *first);
  ExitCode worst = ExitCode::fine;
  work_in_order(
      {thread_count(batch.threads)},
      [&] { return first ? std::exchange(first, std::nullopt) : fetch(queue); },
      [&](const Attempt<SceneText>& scene) { return reply_to(batch, answer, scene); },
      [&](const Reply& reply) {
        deliver(reply);
        worst = std::max(worst, reply.answer.code);
      });
  return worst;
}

std::string json_text(const nlohmann::ordered_json& json, AnswerForm form) {
  return json.dump(form.one_line ? -1 : 2) + "\n";
}

}  // namespace wuerfel
