/// Sine, cosine and arc tangent from + - * / and sqrt only: the same bits on every CPU, which the C
/// library's (chosen by CPU features at load time) do not promise.
#pragma once

#include <cmath>
#include <numbers>

namespace wuerfel {
namespace internal {

inline constexpr double half_pi = 0.5 * std::numbers::pi;

// pi/2 in three parts; the first two have 33 bits, so that k times a part is exact for |k| < 2^20
// [Cody, Waite 1980].
inline constexpr double half_pi_high = 0x1.921fb544p+0;
inline constexpr double half_pi_middle = 0x1.0b4611a6p-34;
inline constexpr double half_pi_low = 0x1.3198a2e037073p-69;

/// sin r for |r| <= pi/4: Taylor series to r^17, truncation below 1e-19.
inline double sine_kernel(double r) {
  const double z = r * r;
  double p = 1.0 / 355687428096000.0;
  p = -1.0 / 1307674368000.0 + z * p;
  p = 1.0 / 6227020800.0 + z * p;
  p = -1.0 / 39916800.0 + z * p;
  p = 1.0 / 362880.0 + z * p;
  p = -1.0 / 5040.0 + z * p;
  p = 1.0 / 120.0 + z * p;
  p = -1.0 / 6.0 + z * p;
  return r + r * z * p;
}

/// cos r for |r| <= pi/4: Taylor series to r^18; 1 - z/2 is rounded once and its error carried
/// along.
inline double cosine_kernel(double r) {
  const double z = r * r;
  double p = -1.0 / 6402373705728000.0;
  p = 1.0 / 20922789888000.0 + z * p;
  p = -1.0 / 87178291200.0 + z * p;
  p = 1.0 / 479001600.0 + z * p;
  p = -1.0 / 3628800.0 + z * p;
  p = 1.0 / 40320.0 + z * p;
  p = -1.0 / 720.0 + z * p;
  p = 1.0 / 24.0 + z * p;
  const double half = 0.5 * z;
  const double w = 1.0 - half;
  return w + (((1.0 - w) - half) + z * z * p);
}

}  // namespace internal

/// Sine and cosine of `angle` (rad), each within 1e-15 for |angle| < 1e6; absolute error grows as
/// 1e-16 |angle| beyond. Not a number for infinite angles.
inline void sin_cos(double angle, double& sine, double& cosine) {
  const double k = std::floor(angle * (1.0 / internal::half_pi) + 0.5);
  const double r = ((angle - k * internal::half_pi_high) - k * internal::half_pi_middle)
                   - k * internal::half_pi_low;
  const double s = internal::sine_kernel(r);
  const double c = internal::cosine_kernel(r);
  const double quadrant = k - 4.0 * std::floor(k * 0.25);
  if (quadrant == 0.0) {
    sine = s;
    cosine = c;
  } else if (quadrant == 1.0) {
    sine = c;
    cosine = -s;
  } else if (quadrant == 2.0) {
    sine = -s;
    cosine = -c;
  } else {
    sine = -c;
    cosine = s;
  }
}

namespace internal {

/// atan t for 0 <= t <= 1: a rough polynomial, then one correction by the true sine and cosine.
inline double first_octant(double y, double x) {
  const double t = y / x;
  const double z = t * t;
  const double rough = t * (0.995354 + z * (-0.288679 + z * 0.079331));
  double s = 0.0;
  double c = 0.0;
  sin_cos(rough, s, c);
  // sin(angle - rough) = (y c - x s) / r, and asin d = d + d^3/6 + 3 d^5/40
  const double d = (t * c - s) / std::sqrt(1.0 + z);
  return rough + (d + d * d * d * (1.0 / 6.0 + d * d * 0.075));
}

}  // namespace internal

/// Angle of (x, y), in (-pi, pi], within 1e-15; 0 for the zero vector.
inline double atan2(double y, double x) {
  const double u = std::abs(x);
  const double v = std::abs(y);
  if (u == 0.0 && v == 0.0) return 0.0;
  double angle =
      v <= u ? internal::first_octant(v, u) : internal::half_pi - internal::first_octant(u, v);
  if (x < 0.0) angle = std::numbers::pi - angle;
  return y < 0.0 ? -angle : angle;
}

}  // namespace wuerfel
