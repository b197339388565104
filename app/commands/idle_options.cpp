#include "app/commands/idle_options.h"

#include <fmt/core.h>

#include "app/cli/exit_code.h"
#include "core/model/system.h"

namespace wuerfel {

void note_idle(const Options& options,
               std::initializer_list<const char*> names,
               const std::string& reason,
               Notes& notes) {
  for (const char* name : names) {
    if (options.given(name)) notes.add(fmt::format("{} does nothing {}", name, reason));
  }
}

void require_effect(const MotionSettings& motion,
                    std::string_view dashes,
                    const std::function<bool(const char*)>& given) {
  const bool by_events =
      motion.integrator == Integrator::automatic || motion.integrator == Integrator::event;
  const bool by_error = by_events || motion.integrator == Integrator::rattle;
  const auto refuse = [&](const char* option, const std::string& reason, const char* others) {
    throw UsageError(
        fmt::format("{0}{1} has no effect with {0}integrator {2}, {3}; it has with {4}", dashes,
                    option, to_string(motion.integrator), reason, others));
  };
  if (by_events && given("step")) {
    refuse("step", fmt::format("whose steps follow from {}tolerance", dashes),
           "rattle, moreau, symplectic and euler");
  }
  if (!by_error && given("tolerance")) {
    refuse("tolerance", fmt::format("whose error follows from {}step", dashes),
           "auto, event and rattle");
  }
  if (by_events && motion.formulation == Formulation::points) {
    refuse("formulation points", "which moves rigid bodies from event to event",
           "rattle, moreau, symplectic and euler, and in `wuerfel check`");
  }
}

void require_effect(const Options& options, const MotionSettings& motion) {
  require_effect(motion, "--",
                 [&](const char* name) { return options.given(std::string("--") + name); });
}

void note_idle_solver(const Options& options, const Scene& scene, Notes& notes) {
  const System system = make_system(scene);
  if (system.rubs || system.bounces) {
    note_idle(options, {"--solver"},
              "for contacts that rub or bounce, whose law has a solver of its own", notes);
  }
}

bool note_what_is_left_out(const Options& options,
                           const Scene& scene,
                           Integrator integrator,
                           Notes& notes) {
  switch (integrator) {
    case Integrator::automatic:
    case Integrator::event:
    case Integrator::rattle:
      note_idle_solver(options, scene, notes);
      return false;
    case Integrator::moreau:
    case Integrator::euler:
    case Integrator::symplectic:
      break;
  }
  const System system = make_system(scene);
  if (!system.rubs && !system.bounces) return false;
  notes.add(
      fmt::format("the scene asks for {}, which --integrator {} does not compute: contacts are "
                  "frictionless and impacts inelastic",
                  system.rubs && system.bounces ? "friction and restitution"
                  : system.rubs                 ? "friction"
                                                : "restitution",
                  to_string(integrator)));
  return true;
}

void note_crowd(const Scene& scene, Layers layers, Notes& notes) {
  if (layers.has(Layer::whiskers) && std::ssize(scene.cubes) >= crowd) {
    notes.add(
        fmt::format("from {} cubes on the layer whiskers shows nothing: it is not asked what "
                    "else forces could be",
                    crowd));
  }
}

void note_idle_colors(const Options& options, ColorBy by, Notes& notes) {
  if (by != ColorBy::load && by != ColorBy::speed)
    note_idle(options, {"--color-top"}, "without --color load or speed", notes);
}

void note_idle_picture_options(const Options& options, Layers layers, Notes& notes) {
  const auto without = [&](Layer layer, const char* name) {
    if (!layers.has(layer))
      note_idle(options, {name}, fmt::format("without the layer {}", to_string(layer)), notes);
  };
  if (!layers.has(Layer::contact_forces) && !layers.has(Layer::weights)
      && !layers.has(Layer::joints))
    without(Layer::forces, "--force-scale");
  if (!layers.has(Layer::joints) && !layers.has(Layer::thrust) && !options.given("--color"))
    without(Layer::forces, "--average");
  without(Layer::accelerations, "--acceleration-scale");
  without(Layer::velocities, "--velocity-scale");
  without(Layer::rod_forces, "--rod-scale");
  without(Layer::hud, "--legend");
  if (layers.has(Layer::whiskers) && !layers.has(Layer::forces)
      && !layers.has(Layer::contact_forces))
    notes.add("the layer whiskers shows nothing without forces or contact-forces");
  if (layers.has(Layer::values) && !layers.has(Layer::forces) && !layers.has(Layer::contact_forces)
      && !layers.has(Layer::joints) && !layers.has(Layer::weights))
    notes.add("the layer values shows nothing without forces, contact-forces, joints or weights");
}

void note_hud(const PictureOptions& picture, PixelSize size, Notes& notes) {
  if (!picture.layers.has(Layer::hud) || picture.layers.has(Layer::instances)) return;
  const HudParts hud =
      hud_parts(make_style(picture.theme), frame_options(picture), size.width, size.height);
  if (hud.foot) return;
  notes.add(fmt::format("{} left out for want of room: take a larger --size or a smaller --scale",
                        hud.head ? "the legend is" : "title and legend are"));
}

std::string left_out(int count, std::string_view one, std::string_view many) {
  return count == 1 ? fmt::format("1 {} has no room and is left out", one)
                    : fmt::format("{} {} have no room and are left out", count, many);
}

void note_labels_left_out(int labels, Notes& notes) {
  if (labels > 0) notes.add(left_out(labels, "label", "labels"));
}

}  // namespace wuerfel
