#include "app/output/picture_outputs.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>

#include <fmt/core.h>

#include "app/cli/argument.h"
#include "app/cli/exit_code.h"
#include "app/cli/is_folder.h"
#include "render/error.h"

namespace wuerfel {

namespace {

bool names_folder(const std::string& name) {
  return name.ends_with('/') || (is_folder(name) && !is_animation_path(name));
}

bool has_even_sides(const std::string& film) {
  return has_suffix(film, ".mp4") || has_suffix(film, ".webm");
}

}  // namespace

void require_picture_output(const std::string& name) {
  if (names_folder(name)) return;
  if (is_folder(name))
    throw OutputError(fmt::format("cannot write the film {}: it is a folder", name));
  if (is_animation_path(name)) return;
  throw UsageError(fmt::format(
      "-o: '{}' is neither a folder (put a / at its end) nor a film (.mp4, .webm, .gif or .apng)",
      name));
}

PictureOutputs::PictureOutputs(const std::vector<std::string>& names,
                               const AnimationSettings& settings,
                               std::optional<double> hold) {
  constexpr double hold_of_loops = 1.0;  // s
  for (const std::string& name : names) {
    if (names_folder(name)) {
      folders_.push_back(std::make_unique<FrameFolder>(name));
    } else {
      films_.push_back(make_animation_writer(name, settings));
      const bool loops = has_suffix(name, ".gif") || has_suffix(name, ".apng");
      repeats_.push_back(std::lround(hold.value_or(loops ? hold_of_loops : 0.0) * settings.fps));
    }
  }
}

void note_film_differences(const std::vector<std::string>& names,
                           const PictureOptions& picture,
                           bool encoder_given,
                           Notes& notes) {
  const auto [width, height] = picture.size;
  for (const std::string& name : names) {
    if (names_folder(name)) continue;
    if (has_even_sides(name) && (width % 2 != 0 || height % 2 != 0)) {
      notes.add(fmt::format("{} is {}x{}: films of its kind have even sides", name,
                            width + width % 2, height + height % 2));
    }
    if (has_suffix(name, ".mp4") && picture.theme == Theme::transparent)
      notes.add(fmt::format("{} has a white background: H.264 has no transparency", name));
  }
  if (encoder_given && std::ranges::none_of(names, names_folder))
    notes.add("--encoder does nothing without a folder of frames");
}

PipelineOutputs PictureOutputs::pipeline_outputs() {
  PipelineOutputs outputs;
  if (!folders_.empty()) {
    outputs.take_png = [this](std::span<const std::uint8_t> file) {
      for (const auto& folder : folders_)
        folder->add(file);
    };
  }
  for (const auto& film : films_)
    outputs.films.push_back(film.get());
  return outputs;
}

void PictureOutputs::finish() {
  for (const auto& folder : folders_)
    folder->finish();
  for (std::size_t i = 0; i < films_.size(); ++i) {
    for (long k = 0; k < repeats_[i]; ++k)
      films_[i]->repeat();
    films_[i]->finish();
  }
}

}  // namespace wuerfel
