#include "core/time/events/contact_changes.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace wuerfel {
namespace {

/// Pairs, each as often as it has contacts, in order.
using Counts = std::vector<IndexPair>;

Counts contacts_of_pairs(const std::vector<Touch>& touches) {
  Counts counts;
  counts.reserve(2 * touches.size());
  for (const Touch& touch : touches)
    counts.insert(counts.end(), touch.count, touch.pair());
  std::ranges::sort(counts);
  return counts;
}

std::ptrdiff_t count_of(const Counts& counts, const IndexPair& pair) {
  const auto [first, last] =
      std::equal_range(counts.begin(), counts.end(), pair);  // of std::ranges: not with Clang 14
  return last - first;
}

/// The touch of the same pair among others.
const Touch* same_touch(const std::vector<Touch>& touches, const Touch& touch) {
  const auto found = std::ranges::find(touches, touch.pair(), &Touch::pair);
  return found == touches.end() ? nullptr : &*found;
}

using NamePair = std::pair<std::string, std::string>;

std::vector<NamePair> named_pairs(const std::vector<Event>& events) {
  std::vector<NamePair> pairs;
  pairs.reserve(events.size());
  for (const Event& e : events)
    pairs.emplace_back(std::minmax(e.on, e.from));
  std::ranges::sort(pairs);
  return pairs;
}

/// Who touched, and who touches.
class Changes {
 public:
  Changes(const System& system,
          const ContactModes& before,
          const ContactModes& after,
          const std::vector<Event>& events)
      : system_(system),
        before_(before),
        after_(after),
        closed_before_(contacts_of_pairs(before.closed.touches)),
        closed_after_(contacts_of_pairs(after.closed.touches)),
        touching_before_(contacts_of_pairs(before.touching)),
        touching_after_(contacts_of_pairs(after.touching)),
        named_(named_pairs(events)) {}

  /// What became of a touch that was closed.
  [[nodiscard]] std::optional<EventKind> end_of(const Touch& touch) const {
    const IndexPair pair = touch.pair();
    const auto had = count_of(closed_before_, pair);
    if (count_of(closed_after_, pair) >= had || is_named(pair)) return {};
    if (rests(pair.first) && rests(pair.second)) return {};
    const double alpha = before_.closed.contacts[touch.first].alpha;
    const bool off = alpha <= same_alpha || alpha >= 1.0 - same_alpha;
    return off && had == 1 ? EventKind::slide_off : EventKind::release;
  }
  /// Whether a touch that is closed has just come.
  [[nodiscard]] bool is_new(const Touch& touch) const {
    const IndexPair pair = touch.pair();
    return count_of(closed_after_, pair) > count_of(closed_before_, pair)
           && count_of(touching_after_, pair) > count_of(touching_before_, pair) && !is_named(pair);
  }
  /// Whether one that was closed and is has begun to stick or to slip.
  [[nodiscard]] std::optional<EventKind> rubs_anew(const Touch& touch) const {
    if (touch.surface.friction <= 0.0) return {};
    const Touch* former = same_touch(before_.closed.touches, touch);
    if (former == nullptr || is_named(touch.pair())) return {};
    if (touch.sticks && !former->sticks) return EventKind::stick;
    if (touch.slips != 0 && touch.slips != former->slips) return EventKind::slip;
    return {};
  }

 private:
  [[nodiscard]] bool rests(int body) const {
    return !system_.is_cube(body) || after_.resting[body] != 0;
  }
  [[nodiscard]] bool is_named(const IndexPair& pair) const {
    if (named_.empty()) return false;
    const auto& [a, b] = pair;
    return std::ranges::binary_search(
        named_, NamePair(std::minmax(system_.body(a).name, system_.body(b).name)));
  }

  const System& system_;
  const ContactModes& before_;
  const ContactModes& after_;
  Counts closed_before_;
  Counts closed_after_;
  Counts touching_before_;
  Counts touching_after_;
  std::vector<NamePair> named_;
};

}  // namespace

void add_contact_changes(const System& system,
                         const ContactModes& before,
                         const ContactModes& after,
                         double t,
                         std::vector<Event>& events) {
  const Changes changes(system, before, after, events);
  const auto add = [&](const Contact& c, std::optional<EventKind> kind) {
    if (!kind) return;
    events.push_back({t, *kind, system.body(c.on).name, system.body(c.from).name, c.point, 0.0});
  };
  for (const Touch& touch : before.closed.touches)
    add(before.closed.contacts[touch.first], changes.end_of(touch));
  for (const Touch& touch : after.closed.touches) {
    const Contact& c = after.closed.contacts[touch.first];
    add(c, changes.rubs_anew(touch));
    if (changes.is_new(touch)) add(c, EventKind::touch);
  }
}

}  // namespace wuerfel
