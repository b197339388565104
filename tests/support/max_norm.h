/// The largest number, of a vector or of a difference.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace wuerfel::test {

/// max |v_i|; 0 if there are none.
inline double largest(const std::vector<double>& v) {
  double most = 0.0;
  for (const double value : v)
    most = std::max(most, std::abs(value));
  return most;
}

/// max |a_i - b_i|; infinite if they differ in size.
inline double distance(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

}  // namespace wuerfel::test
