#include "core/time/events/bounce_series.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace wuerfel {
namespace {

/// Ratios agree up to this share, and so many of them make a series.
constexpr double same_ratio = 1e-3;
constexpr int enough_ratios = 3;
/// Next to the end bounces are as low as what counts as touching, and ratios miss the others by up to this share.
constexpr double rough_ratio = 0.1;

BounceSeries::NamePair pair_of(const Event& e) { return std::minmax(e.on, e.from); }

}  // namespace

void BounceSeries::Series::add(double t) {
  if (t == last) return;
  const double former = interval;
  const double former_ratio = ratio;
  interval = t > last ? t - last : 0.0;
  last = t;
  ratio = former > 0.0 ? interval / former : 0.0;
  const bool agrees = ratio > 0.0 && ratio < 1.0
                      && (agreeing == 0 || std::abs(ratio - former_ratio) <= same_ratio * ratio);
  agreeing = agrees ? agreeing + 1 : 0;
  if (agreeing >= enough_ratios) end = t + interval * ratio / (1.0 - ratio);
  if (std::abs(ratio - former_ratio) > rough_ratio * former_ratio) end = 0.0;
}

void BounceSeries::note(std::vector<Event>& events, const Stays& stays, double most) {
  bool any = false;
  goes_on_ = true;
  for (const Event& e : events) {
    if (e.kind != EventKind::impact) continue;
    const auto [series, first] = of_pair_.try_emplace(pair_of(e), Series{.last = e.t});
    if (!first) series->second.add(e.t);
    any = true;
    goes_on_ = goes_on_ && series->second.converges();
  }
  goes_on_ = goes_on_ && any;
  if (of_pair_.empty()) return;
  date_rests(events, most);
  date_touches(events, stays, most);
}

void BounceSeries::date_touches(std::vector<Event>& events, const Stays& stays, double most) const {
  std::vector<Event> touches;
  std::set<NamePair> dated;
  for (Event e : events) {
    if (e.kind != EventKind::impact) continue;
    const Series& series = of_pair_.at(pair_of(e));
    if (!series.converges() || series.end - e.t > most) continue;
    if (!dated.insert(pair_of(e)).second || !stays(pair_of(e))) continue;
    e.t = series.end;
    e.kind = EventKind::touch;
    e.impulse = 0.0;
    touches.push_back(std::move(e));
  }
  events.insert(events.end(), touches.begin(), touches.end());
}

void BounceSeries::date_rests(std::vector<Event>& events, double most) const {
  for (Event& e : events) {
    if (e.kind != EventKind::rest) continue;
    const auto series = of_pair_.find(pair_of(e));
    if (series == of_pair_.end()) continue;
    const double end = series->second.end;
    if (end > e.t && end - e.t <= most) e.t = end;
  }
}

}  // namespace wuerfel
