#include "core/qp/coulomb/contact_memory.h"

#include <algorithm>

namespace wuerfel {
namespace {

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
                           std::vector<ContactMode>& modes,
                           std::vector<Pair>& l) const {
  const bool same_count = static_cast<int>(units_.size()) == form.count();
  if (units_.empty() || (keys.empty() ? keyed_ > 0 || !same_count : keyed_ == 0)) return false;
  for (int i = 0; i < form.count(); ++i) {
    const Unit* unit = find(i, keys);
    if (unit == nullptr || !fits(form.units()[i], unit->mode)) continue;
    modes[i] = unit->mode;
    l[i] = unit->l;
  }
  return true;
}

void ContactMemory::remember(std::span<const std::uint64_t> keys,
                             const std::vector<ContactMode>& modes,
                             const std::vector<Pair>& l) {
  units_.resize(modes.size());
  keyed_ = static_cast<int>(keys.size());
  for (std::size_t i = 0; i < modes.size(); ++i)
    units_[i] = {i < keys.size() ? keys[i] : 0, modes[i], l[i]};
  std::sort(units_.begin(), units_.begin() + keyed_,
            [](const Unit& a, const Unit& b) { return a.key < b.key; });
}

}  // namespace wuerfel
