#include "core/time/shown_book.h"

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

LostEnergy ShownBook::lost(const Bookkeeping& computed) const {
  LostEnergy lost = over_;
  for (std::size_t k = next_loss_; k < computed.losses.size(); ++k) {
    const Loss& loss = computed.losses[k];
    if (!loss.friction || loss.since >= time_) continue;
    lost.friction += loss.by(time_);
    lost.under_way += loss.energy;
  }
  return lost;
}

}  // namespace wuerfel
