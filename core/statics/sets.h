/// Small sets of numbers.
#pragma once

#include <algorithm>
#include <vector>

namespace wuerfel {

inline bool has(const std::vector<int>& ascending, int cube) {
  return std::ranges::binary_search(ascending, cube);
}

/// Adds a number that is not there yet.
inline void add_once(int number, std::vector<int>& numbers) {
  if (std::ranges::find(numbers, number) == numbers.end()) numbers.push_back(number);
}

}  // namespace wuerfel
