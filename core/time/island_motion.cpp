#include "core/time/island_motion.h"

#include <algorithm>
#include <limits>

namespace wuerfel {

IslandMotion::IslandMotion(const System& system, const MotionSettings& settings, Moment start)
    : system_(&system),
      settings_(settings),
      motion_(system, settings),
      looker_(system, settings),
      moment_(std::move(start)) {
  motion_.start(moment_.state, 0.0, touching_tolerance, {}, computed_);
  advance_to(0.0);
}

void IslandMotion::advance_to(double t) {
  while (motion_.clock() <= t && !(t == 0.0))
    motion_.advance(std::numeric_limits<double>::infinity(), computed_);
  moment_ = {};
  moment_.t = t;
  moment_.state = motion_.at(t);
  looker_.observe(moment_, computed_);
  motion_.forget_before(t);
  shown_.cost = computed_.cost;
  const double loss = shown_.audit.impact_loss;
  shown_.audit = computed_.audit;
  shown_.audit.impact_loss = loss;
  for (; next_event_ < computed_.events.size() && computed_.events[next_event_].t <= t;
       ++next_event_) {
    shown_.events.push_back(computed_.events[next_event_]);
    shown_.audit.impact_loss += shown_.events.back().loss;
  }
}

const Moment& IslandMotion::now_with_forces() {
  looker_.accelerate(moment_, shown_);
  return moment_;
}

}  // namespace wuerfel
