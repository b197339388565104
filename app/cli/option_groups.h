/// Groups of options that several subcommands share. Every value goes through a strict reader; what
/// is not understood is a UsageError that says what it was meant for.
#pragma once

#include <optional>
#include <string>

#include <fmt/core.h>

#include "app/cli/choice.h"
#include "app/cli/options.h"
#include "app/cli/scene_source.h"
#include "app/film/picture_options.h"
#include "app/film/timetable.h"
#include "core/settings.h"
#include "render/picture/film_strip.h"
#include "render/raster/compare.h"

namespace wuerfel {

/// An option that takes the name of an enumerator; messages use the first of its `names`.
template <typename Enum>
void add_choice(Options& options,
                const std::string& names,
                const std::string& meaning,
                Enum& value) {
  const std::string name = names.substr(0, names.find(','));
  const std::string help =
      fmt::format("{}: {} [{}]", meaning, join_choices(choices<Enum>()), to_string(value));
  options.single(names, "NAME", help, [name, &value](const std::string& text) {
    value = parse_choice<Enum>(name, text);
  });
  options.offer(name, choices<Enum>());
}

/// SCENE and --set.
void add_scene(Options& options, SceneChoice& scene);
/// One or more SCENEs and --set, which holds for all of them.
void add_scenes(Options& options,
                std::vector<std::string>& sources,
                std::vector<std::string>& overrides);
/// -j, --jobs.
void add_jobs_option(Options& options, int& threads);
/// --max-memory, which holds from then on.
void add_memory_option(Options& options);
/// --threads, of which each works on one of `what`.
void add_threads_option(Options& options, int& threads, const char* what = "scenes");
/// --formulation and --solver.
void add_solver_options(Options& options, MotionSettings& motion);
/// The same, --integrator, --tolerance and --step.
void add_motion_options(Options& options, MotionSettings& motion);
void add_picture_options(Options& options, PictureOptions& picture);
/// --encoder.
void add_encoder_option(Options& options, PngEncoder& encoder);
/// --fps and --speed.
void add_rate_options(Options& options, FrameRate& rate);
/// --strip.
void add_strip_option(Options& options, std::optional<StripGrid>& strip);
/// --ghosts.
void add_ghosts_option(Options& options, int& ghosts);
/// --max-difference and --max-share.
void add_compare_limits(Options& options, CompareLimits& limits);

}  // namespace wuerfel
