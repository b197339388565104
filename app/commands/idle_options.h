/// Options that do nothing beside the others, so that nothing is left out silently.
#pragma once

#include <functional>
#include <string_view>

#include "app/cli/options.h"
#include "app/cli/streams.h"
#include "app/film/picture_options.h"
#include "core/settings.h"

namespace wuerfel {

/// Notes every one of `names` that was given: "--fps does nothing REASON".
void note_idle(const Options& options,
               std::initializer_list<const char*> names,
               const std::string& reason,
               Notes& notes);

/// Throws UsageError where one of the motion options given (step, tolerance) has no effect with the integrator. `dashes`:
/// before the names of options.
void require_effect(const MotionSettings& motion,
                    std::string_view dashes,
                    const std::function<bool(const char*)>& given);
void require_effect(const Options& options, const MotionSettings& motion);

/// Friction and restitution that a scene asks for and the integrator does not compute; whether there are any.
bool note_what_is_left_out(const Options& options,
                           const Scene& scene,
                           Integrator integrator,
                           Notes& notes);

/// A chosen solver that is not asked where bodies rub or bounce: Coulomb's law has its own.
void note_idle_solver(const Options& options, const Scene& scene, Notes& notes);

/// Layers that have nothing to show of so many cubes.
void note_crowd(const Scene& scene, Layers layers, Notes& notes);

/// The end of a scale of colours where colours tell nothing that has one.
void note_idle_colors(const Options& options, ColorBy by, Notes& notes);

/// Title and legend of pictures of this size that have no room for them.
void note_hud(const PictureOptions& picture, PixelSize size, Notes& notes);

/// So many of them have no room and are left out.
std::string left_out(int count, std::string_view one, std::string_view many);

/// Names and numbers of a picture for which there was no free place.
void note_labels_left_out(int labels, Notes& notes);

/// Picture options of layers that are not drawn.
void note_idle_picture_options(const Options& options, Layers layers, Notes& notes);

}  // namespace wuerfel
