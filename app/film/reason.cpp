#include "app/film/reason.h"

#include <algorithm>

#include "core/statics/carried.h"

namespace wuerfel {

namespace {

// Points have no box in a picture.
std::vector<int> boxes_of(const StillScene& still, const std::vector<int>& bodies) {
  std::vector<int> boxes;
  for (const int body : bodies)
    if (still.system.body(body).kind == BodyKind::cube) boxes.push_back(body);
  return boxes;
}

// Below the centre of mass of a part that tips, at the height of its corner along gravity.
Vec2 beside(const StillScene& still, const Cause& cause) {
  const Vec2 down = still.down();
  return cause.part.centre + down.dot(*cause.corner - cause.part.centre) * down;
}

void mark_cause(const StillScene& still,
                const Cause& cause,
                Language language,
                SnapshotReason& reason) {
  reason.part = boxes_of(still, cause.part.cubes);
  reason.centre = cause.part.centre;
  if (!cause.corner) return;
  reason.corner = cause.corner;
  reason.beside = beside(still, cause);
  reason.label = length_in(language, *cause.outside);
}

void mark_mechanism(const StillScene& still, const Causes& causes, SnapshotReason& reason) {
  double largest = 0.0;
  for (const MovingPart& part : causes.mechanism)
    for (const int cube : part.cubes)
      largest = std::max(largest, causes.certificate.motion[cube].linear.norm());
  if (largest == 0.0) return;
  for (const MovingPart& part : causes.mechanism)
    for (const int cube : boxes_of(still, part.cubes))
      reason.motion.push_back({cube, causes.certificate.motion[cube].linear / largest});
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

}  // namespace

SnapshotReason picture_reason(const Scene& scene, const Explanation& e, Language language) {
  constexpr std::size_t most_lines = 2;
  SnapshotReason reason;
  reason.headlines = sentences(scene, e, language);
  if (reason.headlines.size() > most_lines) reason.headlines.resize(most_lines);
  if (!e.still) return reason;
  if (e.check.verdict == Verdict::falls) {
    reason.headlines.clear();
    if (!e.causes.causes.empty()) {
      mark_cause(*e.still, e.causes.causes.front(), language, reason);
      reason.headlines.push_back(cause_sentence(*e.still, e.causes.causes.front(), language));
    } else {
      mark_mechanism(*e.still, e.causes, reason);
      reason.headlines.push_back(say_in(language, Phrase::no_part_alone));
    }
    mark_fixes(e, language, reason);
  } else if (e.weakest) {
    reason.part = {e.weakest->cube};
  }
  return reason;
}

}  // namespace wuerfel
