/// The scenes of `bench`, from assets/scenes/bench: motions whose states are known exactly
/// (tests/data/bench), and stands that must not move at all.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/state.h"
#include "core/scene/scene.h"
#include "core/time/bookkeeping.h"

namespace wuerfel {

struct KnownEvent {
  EventKind kind = EventKind::impact;
  double time = 0.0;        ///< s
  double look_until = 0.0;  ///< s, a little after it
};

struct BenchScene {
  std::string name;
  Scene scene;
  State exact;        ///< at the end of the scene's duration, one per cube; empty: not known
  bool rests = true;  ///< the exact answer is that nothing moves
  std::optional<KnownEvent> event;
};

/// Motions of few cubes with exact states at their end.
std::vector<std::string> bench_motions();
/// Stands and piles of growing size: FAMILY_N with the families tower, pyramid, wall and pile.
/// N counts cubes of a tower or pile, rows of a pyramid, rows and columns of a wall.
std::vector<std::string> bench_stands();

/// A scene by its name; any N is allowed after tower_, pyramid_, wall_, pile_, mass_ratio_ and tilt_on_wall_ (tilt on a wall of N
/// rows and columns).
/// Throws UsageError where there is none of that name.
BenchScene make_bench_scene(std::string_view name);

/// Ten cubes over the edge of a table, every overhang 1/(2k) times `scale`: stands up to 1, falls
/// above.
Scene harmonic_overhang(double scale);

/// Largest difference of any component: positions relative to the smallest side L, angles in rad,
/// velocities relative to V = sqrt(g L), or the largest speed at the start where g = 0, spins to V
/// / L.
double state_error(const Scene& scene, const State& actual, const State& exact);

/// The same of positions and angles alone.
double place_error(const Scene& scene, const State& actual, const State& exact);

}  // namespace wuerfel
