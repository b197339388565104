#include "core/time/shown_book.h"

#include <algorithm>

namespace wuerfel {

void ShownBook::advance_to(double t, const Bookkeeping& computed) {
  time_ = t;
  const auto& events = computed.events;
  for (; next_event_ < events.size() && events[next_event_].t <= t; ++next_event_)
    book.events.push_back(events[next_event_]);
  const auto& losses = computed.losses;
  for (; next_loss_ < losses.size() && losses[next_loss_].t <= t; ++next_loss_)
    (losses[next_loss_].friction ? over_.friction : over_.impacts) += losses[next_loss_].energy;
}

LostEnergy ShownBook::under_way(const Bookkeeping& computed) const {
  LostEnergy lost;
  for (std::size_t k = next_loss_; k < computed.losses.size(); ++k) {
    const Loss& loss = computed.losses[k];
    if (loss.since < time_) (loss.friction ? lost.friction : lost.impacts) += loss.energy;
  }
  return lost;
}

bool ShownBook::any_under_way(const Bookkeeping& computed) const {
  const LostEnergy more = under_way(computed);
  return more.impacts + more.friction > 0.0;
}

LostEnergy ShownBook::lost(const Bookkeeping& computed, double missing) const {
  const LostEnergy more = under_way(computed);
  const double all = more.impacts + more.friction;
  if (all <= 0.0) return over_;
  const double share = std::clamp((missing - over_.impacts - over_.friction) / all, 0.0, 1.0);
  return {over_.impacts + share * more.impacts, over_.friction + share * more.friction};
}

}  // namespace wuerfel
