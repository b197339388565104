#include "app/python/trajectories.h"

#include <algorithm>
#include <pybind11/stl.h>

#include "app/cli/exit_code.h"
#include "app/python/answers.h"
#include "core/check_many.h"

namespace wuerfel::python {

namespace py = pybind11;

namespace {

/// What a run has to tell; plain C++, so that it can be made without the GIL.
struct Motion {
  std::vector<State> states;
  std::vector<Event> events;
  Audit audit;
  std::vector<std::string> moved;
  bool at_rest = false;
};

Motion run(const Scene& scene,
           const std::vector<double>& times,
           const MotionSettings& settings,
           Interruption& interruption) {
  Simulation simulation(scene, settings);
  simulation.set_pulse([&interruption] { interruption.check(); });
  Motion motion;
  for (const double t : times) {
    simulation.advance_to(t);
    motion.states.push_back(simulation.states());
  }
  motion.events = simulation.events();
  motion.audit = simulation.audit();
  motion.moved = simulation.moved();
  motion.at_rest = simulation.at_rest();
  return motion;
}

void require_times(const std::vector<double>& times) {
  if (!std::ranges::is_sorted(times)) throw UsageError("times must ascend");
  if (!times.empty() && !(times.front() >= 0.0 && times.back() < 1e9))
    throw UsageError("times must be 0 s or later");
}

py::array_t<double> states_array(const Motion& motion, std::size_t bodies) {
  py::array_t<double> array({static_cast<py::ssize_t>(motion.states.size()),
                             static_cast<py::ssize_t>(bodies), state_numbers});
  double* row = array.mutable_data();
  for (const State& state : motion.states) {
    put_state(state, row);
    row += state_numbers * static_cast<py::ssize_t>(bodies);
  }
  return array;
}

py::object trajectory(const Motion& motion,
                      const PyScene& scene,
                      const std::vector<double>& times) {
  py::dict outcome;
  outcome["moved"] = motion.moved;
  outcome["at_rest"] = motion.at_rest;
  return py::module_::import("wuerfel").attr("Trajectory")(
      py::array_t<double>(static_cast<py::ssize_t>(times.size()), times.data()),
      states_array(motion, scene.names().size()), scene.names(), event_list(motion.events),
      audit_dict(motion.audit), outcome);
}

}  // namespace

py::object simulate(const py::object& source,
                    const std::vector<double>& times,
                    const MotionNames& motion) {
  const PyScene scene = load_scene(source);
  const MotionSettings settings = motion.settings();
  require_times(times);
  Interruption interruption;
  Motion result;
  {
    const py::gil_scoped_release others;
    result = run(scene.scene, times, settings, interruption);
  }
  return trajectory(result, scene, times);
}

py::list simulate_many(const std::vector<py::object>& sources,
                       const std::vector<double>& times,
                       int threads,
                       const MotionNames& motion) {
  const std::vector<Attempt<PyScene>> scenes = load_scenes(sources);
  const MotionSettings settings = motion.settings();
  require_times(times);
  Interruption interruption;
  std::vector<Attempt<Motion>> attempts;
  {
    const py::gil_scoped_release others;
    attempts = work_on_each({thread_count(checked_threads(threads)), [&] { interruption.check(); }},
                            static_cast<int>(scenes.size()), [&](int i) {
                              return attempt([&] {
                                if (scenes[i].failure) std::rethrow_exception(scenes[i].failure);
                                return run(scenes[i].answer.scene, times, settings, interruption);
                              });
                            });
  }
  py::list results;
  for (std::size_t i = 0; i < attempts.size(); ++i) {
    results.append(attempts[i].failure != nullptr
                       ? exception_object(attempts[i].failure)
                       : trajectory(attempts[i].answer, scenes[i].answer, times));
  }
  return results;
}

}  // namespace wuerfel::python
