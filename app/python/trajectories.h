/// Whole motions as Python has them.
#pragma once

#include <pybind11/pybind11.h>
#include <vector>

#include "app/python/simulation.h"

namespace wuerfel::python {

/// The motion at these times (s), as a Trajectory. Throws what a command would complain of.
pybind11::object simulate(const pybind11::object& source,
                          const std::vector<double>& times,
                          const MotionNames& motion);
/// One per scene, in order; an exception object in place of one that failed.
pybind11::list simulate_many(const std::vector<pybind11::object>& sources,
                             const std::vector<double>& times,
                             int threads,
                             const MotionNames& motion);

}  // namespace wuerfel::python
