#include "core/statics/move_search.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/statics/limit_motion.h"

namespace wuerfel {
namespace {

/// Ends are known to this share of the smaller side before they are found exactly.
constexpr double seen_to_fall = 1e-7;
/// Likewise, where the motion behind an end is looked at to find that end exactly.
constexpr double seen_to_move = 1e-5;
constexpr int most_looks = 80;

}  // namespace

MoveSearch::MoveSearch(const StillScene& still,
                       const MotionSettings& settings,
                       const CarriedGroup& group)
    : still_(still), settings_(settings), group_(group), side_(smallest_side(still, group)) {}

bool MoveSearch::changes_at(double s, double sense) const {
  if (!std::isfinite(s) || s == 0.0) return false;
  // A neighbour that it meets may hold again what has fallen just before.
  constexpr double nearly = 0.99;
  return stands(s - sense * bracketed * side_) && !stands(s + sense * seen_to_fall * side_)
         && stands(0.5 * s) && stands(nearly * s);
}

MoveSearch::End MoveSearch::end(double in, double out) const {
  const double s = edge(in, out);
  const double step = std::copysign(side_, out - in);
  const double behind = s + seen_to_move * step;
  const std::optional<double> exact =
      at(behind).overlaps
          ? end_of_room(still_, settings_, group_, behind, s + 2.0 * seen_to_move * step)
          : end_of_rest(still_, settings_, group_, s, behind);
  if (exact && std::abs(*exact - s) <= seen_to_fall * side_ && stands(*exact)) return {*exact};
  // The last place on a face that is left: on its end itself nothing holds.
  constexpr double brackets = 4.0;
  if (const auto touch = end_of_touch(still_, group_, s, brackets * bracketed * side_))
    return {*touch};
  return {s, bracketed * side_};
}

double MoveSearch::edge(double in, double out) const {
  double before = out;  // the last place outside but one
  double unrest_before = 0.0;
  MovedScene there = at(out);
  for (int k = 0; k < most_looks && std::abs(out - in) > bracketed * side_; ++k) {
    const double s = guess(in, out, there, before, unrest_before, k);
    const MovedScene now = at(s);
    if (now.verdict == Verdict::stands) {
      in = s;
      // A step on, to see whether that was it.
      const double on = s + std::copysign(bracketed * side_, out - in);
      if (std::abs(out - in) > bracketed * side_ && !stands(on)) return in;
      continue;
    }
    before = out;
    unrest_before = there.unrest;
    out = s;
    there = now;
  }
  return in;
}

MoveSearch::End MoveSearch::first_change(double from, double sense) const {
  constexpr int even_steps = 8;
  const double far = extent() + std::abs(from);
  double in = from;
  double step = 0.25 * side_;
  for (int k = 0; std::abs(in) <= far; ++k) {
    const double out = in + sense * step;
    if (!stands(out)) return end(in, out);
    in = out;
    if (k >= even_steps) step *= 2.0;
  }
  return {sense * unbounded};
}

double MoveSearch::guess(double in,
                         double out,
                         const MovedScene& there,
                         double before,
                         double unrest_before,
                         int k) const {
  const double middle = 0.5 * (in + out);
  constexpr int in_turn = 4;
  if (k % in_turn == in_turn - 1) return middle;
  double s = middle;
  if (there.overlaps) {
    s = out - std::copysign(there.unrest, out - in);
  } else if (before != out && unrest_before != there.unrest) {
    s = out - there.unrest * (before - out) / (unrest_before - there.unrest);
  }
  const bool inside = (s - in) * (out - s) > 0.0;
  return inside ? s : middle;
}

double MoveSearch::extent() const {
  double low = unbounded;
  double high = -unbounded;
  std::vector<Box> boxes;
  pose_boxes(still_.system, still_.state, boxes);
  for (int i = 0; i < still_.system.count(); ++i) {
    if (still_.system.body(i).kind == BodyKind::plane) continue;
    const double at = group_.along.dot(boxes[i].center);
    low = std::min(low, at - boxes[i].radius());
    high = std::max(high, at + boxes[i].radius());
  }
  return high - low;
}

}  // namespace wuerfel
