/// Stands or falls (design, "Verdict").
#pragma once

#include <span>
#include <string_view>

#include "core/model/state.h"

namespace wuerfel {

struct InstantForces;
struct System;

enum class Verdict { stands, falls, moves, undecided };
std::string_view to_string(Verdict verdict);

/// Shares of g: with accelerations below the first a cube stands, above the second it falls.
inline constexpr double stands_below = 1e-10;
inline constexpr double falls_above = 1e-9;

/// The largest |a| + side |alpha| of any cube, or of the proof that it cannot stay at rest, as a share of
/// g. `watched`: of the cubes marked only; empty: of all.
double unrest(const System& system,
              const State& state,
              const InstantForces& found,
              std::span<const char> watched = {});

/// Of the accelerations and forces at a state.
Verdict judge(const System& system,
              const State& state,
              const InstantForces& found,
              std::span<const char> watched = {});

}  // namespace wuerfel
