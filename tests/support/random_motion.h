/// Random smooth motions of points, for comparing derivatives with finite differences.
#pragma once

#include <array>
#include <cstdint>

#include "core/geometry/vec2.h"
#include "core/scene/counter_random.h"

namespace wuerfel::test {

/// Random motions that a row is tried on, and what its first and second derivatives may be off there.
inline constexpr int trials = 200;
inline constexpr double first_tolerance = 1e-10;
inline constexpr double second_tolerance = 1e-7;

/// Numbers in [-1, 1), the same on every machine.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : seed_(seed) {}
  double next() { return 2.0 * random_unit(seed_, count_++) - 1.0; }
  Vec2 next_vec2() {
    const double x = next();
    return {x, next()};
  }

 private:
  std::uint64_t seed_;
  std::uint64_t count_ = 0;
};

/// Numbers between bounds.
class Draw {
 public:
  double operator()(double low, double high) {
    return low + 0.5 * (random_.next() + 1.0) * (high - low);
  }
  Vec2 vector(double size) { return size * random_.next_vec2(); }

 private:
  RandomNumbers random_{5};
};

/// p(t) = c_0 + c_1 t + c_2 t^2 + c_3 t^3, so that v(0) = c_1 and a(0) = 2 c_2.
struct CubicMotion {
  std::array<Vec2, 4> c;
  explicit CubicMotion(RandomNumbers& random) {
    for (Vec2& term : c)
      term = random.next_vec2();
  }
  [[nodiscard]] Vec2 at(double t) const { return c[0] + t * (c[1] + t * (c[2] + t * c[3])); }
  [[nodiscard]] Vec2 v() const { return c[1]; }
  [[nodiscard]] Vec2 a() const { return 2.0 * c[2]; }
};

/// First and second derivative at 0 of a function of time: central differences of fourth order.
template <typename F>
double first_difference(F f, double h) {
  return (8.0 * (f(h) - f(-h)) - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h);
}
template <typename F>
double second_difference(F f, double h) {
  return (16.0 * (f(h) + f(-h)) - (f(2.0 * h) + f(-2.0 * h)) - 30.0 * f(0.0)) / (12.0 * h * h);
}

}  // namespace wuerfel::test
