#include "core/time/motion_history.h"

#include <algorithm>

#include "core/time/partial_motion.h"

namespace wuerfel {
namespace {

constexpr int looks_per_piece = 4;

}  // namespace

/// Number of that piece; -1 where it is not known.
std::ptrdiff_t MotionHistory::number_at(double t) const {
  const auto after =
      std::upper_bound(pieces_.begin(), pieces_.end(), t,
                       [](double time, const MotionPiece& p) { return time < p.begin; });
  return after - pieces_.begin() - 1;
}

const MotionPiece* MotionHistory::piece_at(double t) const {
  const std::ptrdiff_t k = number_at(t);
  return k < 0 ? nullptr : &pieces_[k];
}

State MotionHistory::at(double t, const State& end, EventMotion& events) {
  const std::ptrdiff_t k = number_at(t);
  if (k < 0) return end;
  const MotionPiece& piece = pieces_[k];
  if (piece.part) return piece.part->at(t);
  if (t <= piece.begin || piece.kind == MotionPiece::Kind::rest) return piece.start;
  if (piece.kind == MotionPiece::Kind::smooth) return events.look(piece, t);
  if (!look_) look_ = std::make_unique<StepLook>(*system_, settings_);
  const State& next = k + 1 < std::ssize(pieces_) ? pieces_[k + 1].start : end;
  return look_->at(piece.start, next, piece.length, (t - piece.begin) / piece.length,
                   *piece.record);
}

void MotionHistory::forget_before(double t) {
  while (pieces_.size() > 1 && pieces_[1].begin <= t)
    pieces_.pop_front();
  if (!pieces_.empty() && pieces_.front().part) pieces_.front().part->forget_before(t);
}

void MotionHistory::sweep(double t,
                          double clock,
                          const State& end,
                          std::vector<BoundingBox>& bounds) const {
  const auto add = [&](const State& state) {
    for (std::size_t i = 0; i < state.size(); ++i) {
      bounds[i].include(bounds_around(state[i].position, system_->bodies[i].radius()));
    }
  };
  add(end);
  State state;
  for (auto piece = pieces_.begin(); piece != pieces_.end(); ++piece) {
    const auto next = std::next(piece);
    const double until = next == pieces_.end() ? clock : next->begin;
    if (until < t) continue;
    add(piece->start);
    if (piece->part) piece->part->sweep(t, bounds);
    if (piece->kind != MotionPiece::Kind::smooth) continue;
    // Between its ends a smooth piece leaves the chord: it is looked at along the way.
    const DenseStep motion = motion_of(*system_, *piece);
    state = piece->start;
    for (int k = 1; k < looks_per_piece; ++k) {
      look_at(motion, (until - piece->begin) / piece->length * k / looks_per_piece, state);
      add(state);
    }
  }
}

}  // namespace wuerfel
