/// Numbers that are the same everywhere. [Steele, Lea, Flood 2014]
#pragma once

#include <cstdint>

namespace wuerfel {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  /// In [0, 1).
  double next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
  }
  /// Between e^-spread and e^spread, its logarithm evenly. By products alone: the C library's exp has other last bits
  /// on other CPUs.
  double next_factor(double spread) {
    constexpr int squarings = 8;
    const double x = spread * (2.0 * next() - 1.0) / (1 << squarings);
    double factor = 1.0 + x * (1.0 + x / 2.0 * (1.0 + x / 3.0 * (1.0 + x / 4.0)));
    for (int k = 0; k < squarings; ++k)
      factor *= factor;
    return factor;
  }

 private:
  std::uint64_t state_;
};

}  // namespace wuerfel
