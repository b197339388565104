#include "core/time/events/bounce_series.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

/// Ratios agree up to this share, and so many of them make a series.
constexpr double same_ratio = 1e-3;
constexpr int enough_ratios = 3;

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
}

bool BounceSeries::Series::converges() const { return agreeing >= enough_ratios; }

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
  if (any) date_ends(events, stays, most);
}

void BounceSeries::date_ends(std::vector<Event>& events, const Stays& stays, double most) {
  std::vector<Event> touches;
  std::map<NamePair, double> ends;
  for (Event e : events) {
    if (e.kind != EventKind::impact) continue;
    const Series& series = of_pair_[pair_of(e)];
    if (!series.converges() || series.rest_of_it() > most) continue;
    if (!ends.try_emplace(pair_of(e), series.rest_of_it()).second) continue;
    if (!stays(pair_of(e))) continue;
    e.t += series.rest_of_it();
    e.kind = EventKind::touch;
    e.impulse = 0.0;
    touches.push_back(std::move(e));
  }
  if (ends.empty()) return;
  for (Event& e : events) {
    const auto end = ends.find(pair_of(e));
    if (e.kind == EventKind::rest && end != ends.end()) e.t += end->second;
  }
  events.insert(events.end(), touches.begin(), touches.end());
}

}  // namespace wuerfel
