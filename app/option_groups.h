/// Groups of options that several subcommands share. Every value goes through a strict reader; what
/// is not understood is a UsageError or a RenderError that names the option.
#pragma once

#include <string>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "app/choice.h"
#include "app/commands.h"

namespace wuerfel {

/// An option whose text goes through `take`, once for every time it is given.
template <typename Take>
CLI::Option* add_value(CLI::App& app,
                       const std::string& names,
                       const std::string& type,
                       const std::string& meaning,
                       Take take) {
  return app
      .add_option_function<std::vector<std::string>>(
          names,
          [take](const std::vector<std::string>& values) {
            for (const std::string& value : values)
              take(value);
          },
          meaning)
      ->type_name(type)
      ->allow_extra_args(false);
}

/// An option that may be given once.
template <typename Take>
void add_single(CLI::App& app,
                const std::string& names,
                const std::string& type,
                const std::string& meaning,
                Take take) {
  add_value(app, names, type, meaning, take)->expected(1);
}

/// An option that takes the name of an enumerator.
template <typename Enum>
void add_choice(CLI::App& app, const std::string& name, const std::string& meaning, Enum& value) {
  const std::string help =
      fmt::format("{}: {} [{}]", meaning, join_choices(choices<Enum>()), to_string(value));
  add_single(app, name, "NAME", help,
             [name, &value](const std::string& text) { value = parse_choice<Enum>(name, text); });
}

/// SCENE and --set.
void add_scene(CLI::App& app, SceneChoice& scene);
/// --formulation and --solver.
void add_program_options(CLI::App& app, MotionSettings& motion);
/// The same with --integrator, --tolerance and --step.
void add_motion_options(CLI::App& app, MotionSettings& motion);
/// Options of motions are answered with the reason why they have no effect.
void refuse_motion_options(CLI::App& app);
/// Throws UsageError where one of the motion options given has no effect with the integrator.
void require_effect(const CLI::App& app, const MotionSettings& motion);
void add_picture_options(CLI::App& app, PictureOptions& picture);
/// --encoder.
void add_encoder_option(CLI::App& app, PngEncoder& encoder);
/// --fps and --speed.
void add_rate_options(CLI::App& app, FrameRate& rate);
/// --strip.
void add_strip_option(CLI::App& app, std::optional<StripGrid>& strip);
/// --max-difference and --max-share.
void add_compare_limits(CLI::App& app, CompareLimits& limits);

}  // namespace wuerfel
