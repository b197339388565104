#include "core/qp/coulomb/contact_memory.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace wuerfel {
namespace {

constexpr int oldest = 4;  ///< programs for which a contact's mode is kept

/// Whether the mode is one that the unit can have.
bool fits(const ContactUnit& unit, ContactMode mode) {
  if (unit.equality) return mode == ContactMode::closed;
  if (mode == ContactMode::open) return true;
  if (unit.tangent < 0) return mode == ContactMode::closed;
  if (unit.slides != 0) return mode == slip_mode(unit.slides);
  return mode != ContactMode::closed;
}

}  // namespace

const ContactMemory::Unit* ContactMemory::find(int unit,
                                               std::span<const std::uint64_t> keys) const {
  if (unit >= static_cast<int>(keys.size()))
    return keys.empty() && keyed_ == 0 ? &units_[unit] : nullptr;
  const auto last = units_.begin() + keyed_;
  const auto found = std::lower_bound(units_.begin(), last, keys[unit],
                                      [](const Unit& u, std::uint64_t key) { return u.key < key; });
  return found != last && found->key == keys[unit] ? &*found : nullptr;
}

bool ContactMemory::recall(const ContactForm& form,
                           std::span<const std::uint64_t> keys,
                           double force_unit,
                           std::vector<ContactMode>& modes,
                           std::vector<Pair>& l) const {
  const bool same_count = static_cast<int>(units_.size()) == form.count();
  if (units_.empty() || (keys.empty() ? keyed_ > 0 || !same_count : keyed_ == 0)) return false;
  const double scale = force_unit > 0.0 && force_unit_ > 0.0 ? force_unit / force_unit_ : 1.0;
  for (int i = 0; i < form.count(); ++i) {
    const Unit* unit = find(i, keys);
    if (unit == nullptr || !fits(form.units()[i], unit->mode)) continue;
    modes[i] = unit->mode;
    l[i] = {scale * unit->l.n, scale * unit->l.t};
  }
  return true;
}

/// Into `next_`, by key: contacts of the program, and what is remembered of those that were not in it, but not long ago.
void ContactMemory::merge(std::span<const std::uint64_t> keys,
                          const std::vector<ContactMode>& modes,
                          const std::vector<Pair>& l) {
  std::vector<std::pair<std::uint64_t, int>> present;
  present.reserve(keys.size());
  for (const std::uint64_t key : keys)
    present.emplace_back(key, static_cast<int>(present.size()));
  std::ranges::sort(present);
  auto old = units_.begin();
  const auto last = old + keyed_;
  const auto keep_before = [&](std::uint64_t key) {
    for (; old != last && old->key < key; ++old)
      if (old->age < oldest) next_.push_back({old->key, old->mode, {}, old->age + 1});
  };
  for (const auto& [key, i] : present) {
    keep_before(key);
    if (old != last && old->key == key) ++old;
    next_.push_back({key, modes[i], l[i]});
  }
  keep_before(std::numeric_limits<std::uint64_t>::max());
}

void ContactMemory::remember(std::span<const std::uint64_t> keys,
                             double force_unit,
                             const std::vector<ContactMode>& modes,
                             const std::vector<Pair>& l) {
  next_.clear();
  if (!keys.empty()) merge(keys, modes, l);
  keyed_ = static_cast<int>(next_.size());
  for (std::size_t i = keys.size(); i < modes.size(); ++i)
    next_.push_back({0, modes[i], l[i]});
  units_.swap(next_);
  force_unit_ = force_unit;
}

}  // namespace wuerfel
