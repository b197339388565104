#include "app/film/advance.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {

void advance(
    Simulation& simulation, double t, double step, const StopSignal& stop, Progress& progress) {
  // Within a stride there may be many steps of many cubes.
  simulation.set_pulse([&stop] { stop.check(); });
  constexpr double patience = 1.0 / 60.0;  // s, simulated
  const double stride = std::max(1.0, std::floor(patience / step)) * step;
  for (double k = std::floor(simulation.time() / stride) + 1.0; k * stride < t; ++k) {
    stop.check();
    simulation.advance_to(std::max(k * stride, simulation.time()));
    progress.reached(simulation.time());
  }
  stop.check();
  simulation.advance_to(t);
  simulation.set_pulse({});
  progress.reached(t);
}

}  // namespace wuerfel
