/// Motions as Python has them.
#pragma once

#include <memory>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <string>
#include <vector>

#include "app/python/interruption.h"
#include "app/python/scene.h"
#include "core/settings.h"
#include "core/time/simulation.h"

namespace wuerfel::python {

/// Motion options by the names of the command line. Throws UsageError, also where one that is not the usual has no effect.
struct MotionNames {
  std::string integrator = "auto";
  std::string formulation = "rigid";
  std::string solver = "auto";
  double tolerance = 1e-8;
  double step = 1.0 / 240.0;

  [[nodiscard]] MotionSettings settings() const;
};

class RestartPoints;

/// A simulation that Ctrl-C can stop; after that it is of no more use.
class PySimulation {
 public:
  PySimulation(PyScene scene, const MotionNames& motion);
  /// Of the bytes of `checkpoint`: goes on to the same bits. Throws UsageError where they are none.
  static PySimulation restored(std::string_view bytes);
  PySimulation(PySimulation&&) noexcept;
  PySimulation& operator=(PySimulation&&) noexcept;
  ~PySimulation();

  void advance_to(double t);
  [[nodiscard]] std::string checkpoint() const;
  [[nodiscard]] const Simulation& get() const;
  [[nodiscard]] const PyScene& scene() const { return scene_; }

 private:
  PySimulation(PyScene scene, MotionNames motion, const std::string& restart_point);

  PyScene scene_;
  MotionNames motion_;
  std::unique_ptr<Interruption> interruption_;
  std::unique_ptr<RestartPoints> restarts_;
  std::unique_ptr<Simulation> simulation_;  // none after an interruption
};

/// Of a body in arrays of states: x, y, angle and their rates.
constexpr pybind11::ssize_t state_numbers = 6;
/// Writes them body by body, from `row` on.
void put_state(const State& state, double* row);

/// (cubes, 6): x, y, angle and their rates.
pybind11::array_t<double> state_array(const State& state);
pybind11::dict audit_dict(const Audit& audit);
pybind11::list event_list(const std::vector<Event>& events);

void bind_simulation(pybind11::module_& module);

}  // namespace wuerfel::python
