/// Measures one scene with one setting.
#pragma once

#include "app/bench_methods.h"
#include "app/bench_row.h"
#include "app/bench_scenes.h"

namespace wuerfel {

/// Time: the least of repeats that fill `budget` s, from a Scene in memory to the state at its end,
/// construction and destruction of the Simulation included. Everything else is taken from runs of
/// their own.
BenchRow measure(const BenchScene& scene, const MotionSettings& settings, double budget);

}  // namespace wuerfel
