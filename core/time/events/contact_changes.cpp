#include "core/time/events/contact_changes.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace wuerfel {
namespace {

/// A corner this near to an end of its side, as a share of the side, is at the end.
constexpr double at_end_share = 1e-9;

using Counts = std::map<IndexPair, int>;

Counts contacts_of_pairs(const std::vector<Touch>& touches) {
  Counts counts;
  for (const Touch& touch : touches)
    counts[touch.pair()] += touch.count;
  return counts;
}

int count_of(const Counts& counts, const IndexPair& pair) {
  const auto found = counts.find(pair);
  return found == counts.end() ? 0 : found->second;
}

/// The touch of the same pair among others.
const Touch* same_touch(const std::vector<Touch>& touches, const Touch& touch) {
  const auto found = std::ranges::find(touches, touch.pair(), &Touch::pair);
  return found == touches.end() ? nullptr : &*found;
}

using NamePair = std::pair<std::string, std::string>;

NamePair names(const std::string& a, const std::string& b) { return std::minmax(a, b); }

std::set<NamePair> named_pairs(const std::vector<Event>& events) {
  std::set<NamePair> pairs;
  for (const Event& e : events)
    pairs.insert(names(e.on, e.from));
  return pairs;
}

}  // namespace

void add_contact_changes(const System& system,
                         const ContactModes& before,
                         const ContactModes& after,
                         double t,
                         std::vector<Event>& events) {
  const Counts closed_before = contacts_of_pairs(before.closed.touches);
  const Counts closed_after = contacts_of_pairs(after.closed.touches);
  const Counts touching_before = contacts_of_pairs(before.touching);
  const Counts touching_after = contacts_of_pairs(after.touching);
  const std::set<NamePair> named = named_pairs(events);
  const auto rests = [&](int body) { return !system.is_cube(body) || after.resting[body] != 0; };
  const auto add = [&](const Contact& c, EventKind kind) {
    events.push_back({t, kind, system.body(c.on).name, system.body(c.from).name, c.point, 0.0});
  };
  const auto is_named = [&](const IndexPair& pair) {
    return named.contains(names(system.body(pair.first).name, system.body(pair.second).name));
  };
  for (const Touch& touch : before.closed.touches) {
    const IndexPair pair = touch.pair();
    const int had = count_of(closed_before, pair);
    if ((rests(pair.first) && rests(pair.second)) || is_named(pair)) continue;
    if (count_of(closed_after, pair) >= had) continue;
    const Contact& c = before.closed.contacts[touch.first];
    const bool off = c.alpha <= at_end_share || c.alpha >= 1.0 - at_end_share;
    add(c, off && had == 1 ? EventKind::slide_off : EventKind::release);
  }
  for (const Touch& touch : after.closed.touches) {
    const IndexPair pair = touch.pair();
    const Contact& c = after.closed.contacts[touch.first];
    const Touch* former = same_touch(before.closed.touches, touch);
    if (former != nullptr && !is_named(pair) && touch.surface.friction > 0.0) {
      if (touch.sticks && !former->sticks) add(c, EventKind::stick);
      if (touch.slips != 0 && touch.slips != former->slips) add(c, EventKind::slip);
    }
    if (count_of(closed_after, pair) <= count_of(closed_before, pair) || is_named(pair)) continue;
    if (count_of(touching_after, pair) <= count_of(touching_before, pair)) continue;
    add(c, EventKind::touch);
  }
}

}  // namespace wuerfel
