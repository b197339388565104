/// Measures a peer as `bench` measures us: same scenes, same clock, same errors.
#pragma once

#include "tests/benchmark/bench/row.h"
#include "tests/benchmark/bench/scenes.h"
#include "tests/benchmark/peers/peer.h"

namespace wuerfel::bench {

/// Time: the least of repeats that fill `budget` s, from making the world to taking it down.
BenchRow measure_peer(const Peer& peer, const BenchScene& scene, double step, double budget);

/// Whether a harmonic overhang of this scale still stands after 5 s: its top cube has moved by less
/// than 5 cm and turned by less than 0.05 rad.
bool overhang_stands(const Peer& peer, double scale, double step);
bool overhang_stands(double scale);

}  // namespace wuerfel::bench
