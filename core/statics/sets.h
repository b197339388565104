/// Small sets of numbers.
#pragma once

#include <algorithm>
#include <vector>

namespace wuerfel {

inline bool has(const std::vector<int>& ascending, int cube) {
  return std::ranges::binary_search(ascending, cube);
}

/// Adds a contact that is not there yet.
inline void add_once(int contact, std::vector<int>& contacts) {
  if (std::ranges::find(contacts, contact) == contacts.end()) contacts.push_back(contact);
}

}  // namespace wuerfel
