/// Iterative refinement: what a factor makes of what is left, added, and again.
#pragma once

namespace wuerfel {

/// Each round gains as many digits as the factor has; where three do not reach rounding none will.
inline constexpr int most_refinements = 3;

}  // namespace wuerfel
