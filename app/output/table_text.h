/// Names and numbers of tables that people read.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace wuerfel {

/// 0 for what is rounding beside the largest number of its kind.
inline double rounded(double value, double largest) {
  constexpr double rounding = 1e-12;
  return std::abs(value) <= rounding * largest ? 0.0 : value;
}

/// The width of a column of names: that of the longest.
class NameColumn {
 public:
  void include(const std::string& name) { width_ = std::max(width_, name.size()); }
  [[nodiscard]] std::size_t width() const { return width_; }

 private:
  std::size_t width_ = 14;
};

}  // namespace wuerfel
