/// What a picture carries so that it can be made again: version, options, time and scene; no date,
/// path or host.
#pragma once

#include <string>
#include <vector>

#include "core/settings.h"
#include "render/files/png.h"

namespace wuerfel {

/// Keys of the texts.
constexpr const char* software_key = "Software";
constexpr const char* time_key = "Simulated time";
constexpr const char* options_key = "Options";
constexpr const char* scene_key = "Scene";

/// The time of a picture in s; a film strip has several.
PngText time_text(const std::vector<double>& times);

/// What all pictures of a run have in common.
std::vector<PngText> origin_texts(const std::string& options, const std::string& normalised_scene);

/// The motion options as they would be written on the command line.
std::string option_text(const MotionSettings& motion);

}  // namespace wuerfel
