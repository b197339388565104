#include "core/geometry/trig.h"

#include <cmath>
#include <numbers>

namespace wuerfel {
namespace {

constexpr double half_pi = 0.5 * std::numbers::pi;

// pi/2 in three parts; the first two have 33 bits, so that k times a part is exact for |k| < 2^20
// [Cody, Waite 1980].
constexpr double half_pi_high = 0x1.921fb544p+0;
constexpr double half_pi_middle = 0x1.0b4611a6p-34;
constexpr double half_pi_low = 0x1.3198a2e037073p-69;

/// sin r for |r| <= pi/4: Taylor series to r^17, truncation below 1e-19.
double sine_kernel(double r) {
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
double cosine_kernel(double r) {
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

/// atan t for 0 <= t <= 1: a rough polynomial, then one correction by the true sine and cosine.
double first_octant(double y, double x) {
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

}  // namespace

void sin_cos(double angle, double& sine, double& cosine) {
  const double k = std::floor(angle * (1.0 / half_pi) + 0.5);
  const double r = ((angle - k * half_pi_high) - k * half_pi_middle) - k * half_pi_low;
  const double s = sine_kernel(r);
  const double c = cosine_kernel(r);
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

double atan2(double y, double x) {
  const double u = std::abs(x);
  const double v = std::abs(y);
  if (u == 0.0 && v == 0.0) return 0.0;
  double angle = v <= u ? first_octant(v, u) : half_pi - first_octant(u, v);
  if (x < 0.0) angle = std::numbers::pi - angle;
  return y < 0.0 ? -angle : angle;
}

}  // namespace wuerfel
