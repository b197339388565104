/// The largest number, of a vector or of a difference: of two states, too.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/model/state.h"

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

/// The largest difference of positions (m) and angles (rad) of two states of the same bodies.
inline double distance(const State& a, const State& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most =
        std::max({most, (a[i].position - b[i].position).norm(), std::abs(a[i].angle - b[i].angle)});
  }
  return most;
}

}  // namespace wuerfel::test
