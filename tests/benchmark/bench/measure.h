/// Measures one scene with one setting.
#pragma once

#include "tests/benchmark/bench/methods.h"
#include "tests/benchmark/bench/row.h"
#include "tests/benchmark/bench/scenes.h"

namespace wuerfel {

/// Time: the least of repeats that fill `budget` s, from a Scene in memory to the state at its end,
/// construction and destruction of the Simulation included. Everything else is taken from runs of
/// their own.
BenchRow measure(const BenchScene& scene, const MotionSettings& settings, double budget);

}  // namespace wuerfel
