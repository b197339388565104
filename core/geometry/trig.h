/// Sine, cosine and arc tangent from + - * / and sqrt only: the same bits on every CPU, which the C
/// library's (chosen by CPU features at load time) do not promise.
#pragma once

namespace wuerfel {

/// Sine and cosine of `angle` (rad), each within 1e-15 for |angle| < 1e6; absolute error grows as
/// 1e-16 |angle| beyond. Not a number for infinite angles.
void sin_cos(double angle, double& sine, double& cosine);

/// Angle of (x, y), in (-pi, pi], within 1e-15; 0 for the zero vector.
double atan2(double y, double x);

}  // namespace wuerfel
