#include "core/qp/coulomb/contact_memory.h"

#include <algorithm>
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

/// Modes of contacts that were not in the program of these keys, but not long ago.
std::vector<ContactMemory::Unit> ContactMemory::others(std::span<const std::uint64_t> keys) const {
  std::vector<std::uint64_t> present(keys.begin(), keys.end());
  std::ranges::sort(present);
  std::vector<Unit> others;
  for (int i = 0; i < keyed_; ++i) {
    const Unit& unit = units_[i];
    if (unit.age < oldest && !std::ranges::binary_search(present, unit.key))
      others.push_back({unit.key, unit.mode, {}, unit.age + 1});
  }
  return others;
}

void ContactMemory::remember(std::span<const std::uint64_t> keys,
                             double force_unit,
                             const std::vector<ContactMode>& modes,
                             const std::vector<Pair>& l) {
  std::vector<Unit> units;
  if (!keys.empty()) units = others(keys);
  keyed_ = static_cast<int>(units.size() + keys.size());
  for (std::size_t i = 0; i < modes.size(); ++i)
    units.push_back({i < keys.size() ? keys[i] : 0, modes[i], l[i]});
  units_ = std::move(units);
  force_unit_ = force_unit;
  std::ranges::sort(units_.begin(), units_.begin() + keyed_, {}, &Unit::key);
}

}  // namespace wuerfel
