#include "core/time/events/contact_changes.h"

#include <algorithm>

namespace wuerfel {
namespace {

IndexPair pair_of(const Contact& c) { return std::minmax(c.on, c.from); }

}  // namespace

void log_changes(const System& system,
                 const std::vector<Contact>& before,
                 const std::vector<Contact>& after,
                 const std::vector<char>& resting,
                 double t,
                 std::size_t first_event,
                 Bookkeeping& book) {
  const auto count = [](const std::vector<Contact>& contacts, const IndexPair& pair) {
    return std::ranges::count_if(contacts, [&](const Contact& c) { return pair_of(c) == pair; });
  };
  const auto hit = [&](const IndexPair& pair) {
    return std::any_of(book.events.begin() + static_cast<std::ptrdiff_t>(first_event),
                       book.events.end(), [&](const Event& e) {
                         const auto& a = system.body(pair.first).name;
                         const auto& b = system.body(pair.second).name;
                         return (e.on == a && e.from == b) || (e.on == b && e.from == a);
                       });
  };
  const auto rests = [&](int body) { return !system.is_cube(body) || resting[body] != 0; };
  const auto log = [&](const Contact& c, EventKind kind) {
    book.events.push_back(
        {t, kind, system.body(c.on).name, system.body(c.from).name, c.point, 0.0});
  };
  for (std::size_t k = 0; k < before.size(); ++k) {
    const IndexPair pair = pair_of(before[k]);
    if (k > 0 && pair_of(before[k - 1]) == pair) continue;
    if (rests(pair.first) && rests(pair.second)) continue;
    if (count(after, pair) < count(before, pair) && !hit(pair)) {
      const bool off = before[k].alpha <= 1e-9 || before[k].alpha >= 1.0 - 1e-9;
      log(before[k], off && count(before, pair) == 1 ? EventKind::slide_off : EventKind::release);
    }
  }
  if (t == 0.0) return;
  for (std::size_t k = 0; k < after.size(); ++k) {
    const IndexPair pair = pair_of(after[k]);
    if (k > 0 && pair_of(after[k - 1]) == pair) continue;
    if (count(after, pair) > count(before, pair) && !hit(pair)) log(after[k], EventKind::touch);
  }
}

}  // namespace wuerfel
