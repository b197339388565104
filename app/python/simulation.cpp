#include "app/python/simulation.h"

#include <pybind11/stl.h>

#include <fmt/format.h>

#include "app/cli/choice.h"
#include "app/commands/idle_options.h"
#include "app/python/answers.h"
#include "app/python/checkpoints.h"
#include "app/python/trajectories.h"
#include "core/time/restart_point.h"

namespace wuerfel::python {

namespace py = pybind11;

void put_state(const State& state, double* row) {
  for (const BodyState& body : state) {
    for (const double value : {body.position.x(), body.position.y(), body.angle, body.velocity.x(),
                               body.velocity.y(), body.spin})
      *row++ = value;
  }
}

MotionSettings MotionNames::settings() const {
  MotionSettings settings;
  settings.integrator = parse_choice<Integrator>("integrator", integrator);
  settings.formulation = parse_choice<Formulation>("formulation", formulation);
  settings.solver = parse_choice<QpMethod>("solver", solver);
  if (!(tolerance >= 1e-15) || !(step > 0.0))
    throw UsageError("tolerance must be at least 1e-15 and step greater than 0");
  settings.tolerance = tolerance;
  settings.step = step;
  const MotionNames usual;
  require_effect(settings, "", [&](std::string_view name) {
    return name == "step" ? step != usual.step : tolerance != usual.tolerance;
  });
  return settings;
}

py::array_t<double> state_array(const State& state) {
  py::array_t<double> array({static_cast<py::ssize_t>(state.size()), state_numbers});
  put_state(state, array.mutable_data());
  return array;
}

py::dict audit_dict(const Audit& audit) {
  py::dict dict;
  dict["max_penetration"] = audit.max_penetration;
  dict["max_rod_error"] = audit.max_rod_error;
  dict["rods_contradicting"] = audit.rods_contradicting;
  dict["max_kkt_residual"] = audit.max_kkt_residual;
  dict["energy_start"] = audit.energy_start;
  dict["energy_end"] = audit.energy_end;
  dict["impact_loss"] = audit.impact_loss;
  dict["friction_loss"] = audit.friction_loss;
  dict["drift"] = audit.drift();
  return dict;
}

py::list event_list(const std::vector<Event>& events) {
  py::list list;
  for (const Event& event : events) {
    py::dict dict;
    dict["t"] = event.t;
    dict["kind"] = std::string(to_string(event.kind));
    dict["bodies"] = py::make_tuple(event.on, event.from);
    dict["point"] = py::make_tuple(event.point.x(), event.point.y());
    dict["impulse"] = event.impulse;
    list.append(dict);
  }
  return list;
}

PySimulation::PySimulation(PyScene scene, const MotionNames& motion)
    : PySimulation(std::move(scene), motion, "") {}

PySimulation::PySimulation(PyScene scene, MotionNames motion, const std::string& restart_point)
    : scene_(std::move(scene)),
      motion_(std::move(motion)),
      interruption_(std::make_unique<Interruption>()),
      restarts_(std::make_unique<RestartPoints>()) {
  const std::size_t cubes = scene_.scene.cubes.size();
  if (restart_point.empty()) {
    simulation_ = std::make_unique<Simulation>(scene_.scene, motion_.settings());
  } else {
    simulation_ = std::make_unique<Simulation>(scene_.scene, motion_.settings(), restart_point);
    restarts_->note(restart_point, cubes);
  }
  simulation_->set_pulse([watch = interruption_.get()] { watch->check(); });
  simulation_->set_restart_listener([restarts = restarts_.get(), cubes](std::string point) {
    restarts->note(std::move(point), cubes);
  });
}

PySimulation::PySimulation(PySimulation&&) noexcept = default;
PySimulation& PySimulation::operator=(PySimulation&&) noexcept = default;
PySimulation::~PySimulation() = default;

PySimulation PySimulation::restored(std::string_view bytes) {
  try {
    SimulationRecord record = record_of(bytes);
    PyScene scene{{"checkpoint", std::move(record.scene)}, {}, {}};
    scene.scene = parse(scene.text, {});
    PySimulation simulation(std::move(scene), std::move(record.motion), record.restart_point);
    simulation.advance_to(record.t);
    return simulation;
  } catch (const RestartError& error) {
    throw UsageError(fmt::format("checkpoint: the bytes are damaged: {}", error.what()));
  }
}

std::string PySimulation::checkpoint() const {
  const double t = get().time();
  return to_bytes({scene_.json(), motion_, t, restarts_->before(t)});
}

const Simulation& PySimulation::get() const {
  if (!simulation_) throw std::runtime_error("this simulation was interrupted; make a new one");
  return *simulation_;
}

void PySimulation::advance_to(double t) {
  if (!(t >= get().time() && t < 1e9))
    throw UsageError(fmt::format("the simulation is at {} s and cannot go to {}", get().time(), t));
  const py::gil_scoped_release others;
  try {
    restarts_->expect(t);
    simulation_->advance_to(t);
  } catch (...) {
    simulation_.reset();
    throw;
  }
}

void bind_simulation(py::module_& module) {
  const auto motion_arguments = [](const std::string& integrator, const std::string& formulation,
                                   const std::string& solver, double tolerance, double step) {
    return MotionNames{integrator, formulation, solver, tolerance, step};
  };
  const MotionNames usual;
  py::class_<PySimulation>(module, "Simulation", "A scene in motion.")
      .def(py::init([=](const py::object& scene, const std::string& integrator,
                        const std::string& formulation, const std::string& solver, double tolerance,
                        double step) {
             return PySimulation(load_scene(scene), motion_arguments(integrator, formulation,
                                                                     solver, tolerance, step));
           }),
           py::arg("scene"), py::kw_only(), py::arg("integrator") = usual.integrator,
           py::arg("formulation") = usual.formulation, py::arg("solver") = usual.solver,
           py::arg("tolerance") = usual.tolerance, py::arg("step") = usual.step,
           "Options as of `wuerfel run`.")
      .def("advance_to", &PySimulation::advance_to, py::arg("t"),
           "Moves on to time t (s) exactly; the state is that just after an event that falls on t.")
      .def(
          "checkpoint", [](const PySimulation& s) { return py::bytes(s.checkpoint()); },
          "Bytes that `restore` makes the simulation of again: it goes on to the same bits.")
      .def_static(
          "restore", [](const std::string& bytes) { return PySimulation::restored(bytes); },
          py::arg("checkpoint"), "The simulation of these bytes, at the time it had.")
      .def(py::pickle(
          [](const PySimulation& s) { return py::bytes(s.checkpoint()); },
          [](const py::bytes& bytes) { return PySimulation::restored(std::string(bytes)); }))
      .def_property_readonly(
          "time", [](const PySimulation& s) { return s.get().time(); }, "s")
      .def_property_readonly(
          "state", [](const PySimulation& s) { return state_array(s.get().states()); },
          "(bodies, 6) float64, a copy: x, y, angle, vx, vy, spin; SI units.")
      .def_property_readonly("names", [](const PySimulation& s) { return s.scene().names(); })
      .def_property_readonly("scene", [](const PySimulation& s) { return s.scene(); })
      .def_property_readonly("events",
                             [](const PySimulation& s) { return event_list(s.get().events()); })
      .def_property_readonly("audit",
                             [](const PySimulation& s) { return audit_dict(s.get().audit()); })
      .def_property_readonly(
          "moved", [](const PySimulation& s) { return s.get().moved(); },
          "Names of cubes that have moved by more than rounding.")
      .def_property_readonly(
          "at_rest", [](const PySimulation& s) { return s.get().at_rest(); },
          "Whether all stand still, certified.");
  module.def(
      "simulate",
      [=](const py::object& scene, const std::vector<double>& times, const std::string& integrator,
          const std::string& formulation, const std::string& solver, double tolerance,
          double step) {
        return simulate(scene, times,
                        motion_arguments(integrator, formulation, solver, tolerance, step));
      },
      py::arg("scene"), py::arg("times"), py::kw_only(), py::arg("integrator") = usual.integrator,
      py::arg("formulation") = usual.formulation, py::arg("solver") = usual.solver,
      py::arg("tolerance") = usual.tolerance, py::arg("step") = usual.step,
      "The motion at these times (s, ascending), as a Trajectory. Other threads run meanwhile.");
  module.def(
      "simulate_many",
      [=](const std::vector<py::object>& scenes, const std::vector<double>& times, int threads,
          const std::string& integrator, const std::string& formulation, const std::string& solver,
          double tolerance, double step) {
        return simulate_many(scenes, times, threads,
                             motion_arguments(integrator, formulation, solver, tolerance, step));
      },
      py::arg("scenes"), py::arg("times"), py::kw_only(), py::arg("threads") = 0,
      py::arg("integrator") = usual.integrator, py::arg("formulation") = usual.formulation,
      py::arg("solver") = usual.solver, py::arg("tolerance") = usual.tolerance,
      py::arg("step") = usual.step,
      "One Trajectory per scene, in order, by threads (0: one per core), an exception object in "
      "place of one that failed. The same bits for any number of threads.");
}

}  // namespace wuerfel::python
