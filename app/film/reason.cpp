#include "app/film/reason.h"

#include <algorithm>
#include <span>

#include "core/statics/carried.h"
#include "core/time/shown_causes.h"

namespace wuerfel {

namespace {

// Points have no box in a picture.
std::vector<int> boxes_of(const StillScene& still, const std::vector<int>& bodies) {
  std::vector<int> boxes;
  for (const int body : bodies)
    if (still.system.body(body).kind == BodyKind::cube) boxes.push_back(body);
  return boxes;
}

SnapshotReason::Fix mark_fix(const StillScene& still, const Fix& fix, Language language) {
  SnapshotReason::Fix mark;
  mark.point = fix.point;
  mark.force = fix.force;
  mark.label = force_in(language, fix.force.norm(), Rounding::up);
  if (fix.kind == Fix::Kind::force) return mark;
  mark.moved = boxes_of(still, carried_group(still, fix.cube)->cubes);
  mark.way = fix.distance * fix.along;
  mark.label = length_in(language, std::abs(fix.distance), Rounding::up);
  return mark;
}

// The first move and the first force: of each kind the smallest.
void mark_fixes(const Explanation& e, Language language, SnapshotReason& reason) {
  for (const Fix::Kind kind : {Fix::Kind::move, Fix::Kind::force}) {
    const auto fix = std::ranges::find(e.fixes, kind, &Fix::kind);
    if (fix == e.fixes.end()) continue;
    reason.fixes.push_back(mark_fix(*e.still, *fix, language));
    reason.advice.push_back(fix_sentence(*e.still, *fix, language));
  }
}

// What the text names first, in words and as marks.
void mark_causes(const Explanation& e, Language language, Snapshot& snapshot) {
  constexpr std::size_t most_causes = 2;
  snapshot.reason->headlines.clear();
  for (const Cause& cause :
       std::span(e.causes.causes).first(std::min(most_causes, e.causes.causes.size()))) {
    SnapshotCause& shown = snapshot.causes.emplace_back(shown_cause(*e.still, cause));
    if (cause.outside) shown.label = length_in(language, *cause.outside);
    snapshot.reason->headlines.push_back(cause_sentence(*e.still, cause, language));
  }
}

}  // namespace

Layers reason_layers(const Explanation& e) {
  const bool mechanism = e.check.verdict == Verdict::falls && e.causes.causes.empty();
  return {mechanism ? Layer::mechanism : Layer::causes};
}

void add_reason(const Scene& scene, const Explanation& e, Language language, Snapshot& snapshot) {
  constexpr std::size_t most_lines = 2;
  SnapshotReason& reason = snapshot.reason.emplace();
  reason.headlines = sentences(scene, e, language);
  if (reason.headlines.size() > most_lines) reason.headlines.resize(most_lines);
  if (!e.still) return;
  if (e.check.verdict == Verdict::falls) {
    if (!e.causes.causes.empty()) {
      mark_causes(e, language, snapshot);
    } else {
      snapshot.mechanism = shown_motion(*e.still, e.causes.certificate);
      reason.headlines = mechanism_sentences(e, language);
    }
    mark_fixes(e, language, reason);
  } else if (e.weakest) {
    snapshot.causes = {{.part = {e.weakest->cube}}};
  }
}

}  // namespace wuerfel
