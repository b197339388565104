#include "app/commands/idle_options.h"

#include <fmt/core.h>

namespace wuerfel {

void note_idle(const Options& options,
               std::initializer_list<const char*> names,
               const std::string& reason,
               Notes& notes) {
  for (const char* name : names) {
    if (options.given(name)) notes.add(fmt::format("{} does nothing {}", name, reason));
  }
}

void note_idle_motion_options(const Options& options, const MotionSettings& motion, Notes& notes) {
  const std::string with = fmt::format("with --integrator {}", to_string(motion.integrator));
  switch (motion.integrator) {
    case Integrator::automatic:
    case Integrator::event:
      note_idle(options, {"--step"}, with, notes);
      if (motion.formulation == Formulation::points) {
        notes.add(fmt::format(
            "--formulation points {} says how the programs of events are written; between events "
            "cubes move as rigid bodies",
            with));
      }
      break;
    case Integrator::rattle:
      break;
    case Integrator::moreau:
    case Integrator::euler:
    case Integrator::symplectic:
      note_idle(options, {"--tolerance"}, with, notes);
      break;
  }
}

void note_idle_picture_options(const Options& options, Layers layers, Notes& notes) {
  const auto without = [&](Layer layer, const char* name) {
    if (!layers.has(layer))
      note_idle(options, {name}, fmt::format("without the layer {}", to_string(layer)), notes);
  };
  without(Layer::forces, "--force-scale");
  without(Layer::velocities, "--velocity-scale");
  without(Layer::rod_forces, "--rod-scale");
}

}  // namespace wuerfel
