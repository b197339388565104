#include "app/output/picture_outputs.h"

#include <filesystem>
#include <system_error>

#include <fmt/core.h>

#include "app/cli/exit_code.h"
#include "render/error.h"

namespace wuerfel {

namespace {

bool names_folder(const std::string& name) {
  std::error_code ignored;
  return name.ends_with('/') || std::filesystem::is_directory(name, ignored);
}

}  // namespace

void require_picture_output(const std::string& name) {
  if (names_folder(name) || is_animation_path(name)) return;
  throw UsageError(fmt::format(
      "-o: '{}' is neither a folder (put a / at its end) nor a film (.mp4, .webm, .gif or .apng)",
      name));
}

PictureOutputs::PictureOutputs(const std::vector<std::string>& names,
                               const AnimationSettings& settings) try {
  for (const std::string& name : names) {
    if (names_folder(name)) {
      folders_.push_back(std::make_unique<FrameFolder>(name));
    } else {
      films_.push_back(make_animation_writer(name, settings));
    }
  }
} catch (const RenderError& error) {
  throw UsageError(error.what());
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
  for (const auto& film : films_)
    film->finish();
}

}  // namespace wuerfel
