/// Steps of interior point methods.
#pragma once

namespace wuerfel {

/// Share of the way to where a first force or slack comes to zero: products stay alike. [Mehrotra 1992]
inline constexpr double to_the_boundary = 0.995;

}  // namespace wuerfel
