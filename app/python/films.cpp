#include "app/python/films.h"

#include <pybind11/stl.h>

#include "app/cli/exit_code.h"
#include "app/commands/run_books.h"
#include "app/commands/run_plan.h"
#include "app/python/interruption.h"
#include "app/python/pictures.h"
#include "app/python/scene.h"
#include "app/python/simulation.h"

namespace wuerfel::python {

namespace py = pybind11;

namespace {

// As `wuerfel run -o`, up to the bits of the frames.
void film(const RunOptions& asked, const Scene& scene) {
  Interruption interruption;
  const StopSignal deaf(StopSignal::Ear::deaf);
  const RunPlan plan = make_plan(asked, scene);
  AnimationSettings animation = animation_settings(asked.picture, asked.rate.fps, scene);
  animation.while_waiting = [&interruption] { interruption.check(); };
  RunOutputs outputs(asked, animation);
  const MotionSource source{
      scene, asked.motion, instants_of(asked, plan), plan.request, plan.request, plan.back, deaf};
  RunBooks books(asked, source, outputs);
  Simulation simulation(scene, asked.motion);
  simulation.set_pulse([&interruption] { interruption.check(); });
  for (const TimetableEntry& instant : source.instants) {
    simulation.advance_to(instant.t);
    if (is_seen(instant)) books.take(instant, simulation, simulation.moment());
  }
  books.finish(simulation, Progress::Style::silent);
}

void save_film(const py::object& source, const py::object& path, RunOptions asked) {
  const PyScene scene = load_scene(source);
  asked.outputs = {py::str(py::module_::import("os").attr("fsdecode")(path))};
  require_picture_output(asked.outputs.front());
  if (!(asked.rate.fps > 0.0 && asked.rate.speed > 0.0))
    throw UsageError("fps and speed must be greater than 0");
  if (asked.until && !(*asked.until >= 0.0)) throw UsageError("until must be 0 s or later");
  const py::gil_scoped_release others;
  film(asked, scene.scene);
}

}  // namespace

void bind_films(py::module_& module) {
  const PictureNames usual;
  const MotionNames motion;
  module.def(
      "save_film",
      [](const py::object& scene, const py::object& path, double fps, double speed,
         std::optional<double> until, std::pair<int, int> size, const std::string& layers,
         const std::string& theme, const std::string& view, double scale,
         const std::string& integrator, const std::string& formulation, const std::string& solver,
         double tolerance, double step) {
        RunOptions asked;
        asked.picture = PictureNames{size, layers, theme, view, scale}.options();
        asked.motion = MotionNames{integrator, formulation, solver, tolerance, step}.settings();
        asked.rate = {fps, speed};
        asked.until = until;
        save_film(scene, path, asked);
      },
      py::arg("scene"), py::arg("path"), py::kw_only(), py::arg("fps") = 30.0,
      py::arg("speed") = 1.0, py::arg("until") = py::none(), py::arg("size") = usual.size,
      py::arg("layers") = usual.layers, py::arg("theme") = usual.theme,
      py::arg("view") = usual.view, py::arg("scale") = usual.scale,
      py::arg("integrator") = motion.integrator, py::arg("formulation") = motion.formulation,
      py::arg("solver") = motion.solver, py::arg("tolerance") = motion.tolerance,
      py::arg("step") = motion.step,
      "Simulates the scene and films it: path is .mp4, .webm, .gif or .apng, or ends in / for a "
      "folder of frames; the frames of `wuerfel run -o`. Films need ffmpeg. until: s, None for the "
      "scene's duration; speed 0.1 is slow motion.");
}

}  // namespace wuerfel::python
