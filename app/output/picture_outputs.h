/// All the places that frames go to.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/streams.h"
#include "app/film/picture_options.h"
#include "app/output/frame_folder.h"
#include "render/files/animation.h"
#include "render/pipeline/frame_pipeline.h"

namespace wuerfel {

class PictureOutputs {
 public:
  /// Folders and films by their names. Throws OutputError where one of them cannot be made or
  /// ffmpeg is missing, and RenderError where a film cannot have these settings.
  /// A film shows its last frame for `hold` s more; none: a second where it starts anew by itself.
  PictureOutputs(const std::vector<std::string>& names,
                 const AnimationSettings& settings,
                 std::optional<double> hold = std::nullopt);

  [[nodiscard]] bool empty() const { return folders_.empty() && films_.empty(); }

  /// All of them as a pipeline wants them; valid as long as this object.
  PipelineOutputs pipeline_outputs();
  /// Completes all of them. Films appear only now. Throws OutputError.
  void finish();

 private:
  std::vector<std::unique_ptr<FrameFolder>> folders_;
  std::vector<std::unique_ptr<AnimationWriter>> films_;
  std::vector<long> repeats_;  // of the last frame of each film
};

/// Notes where a film cannot be what was asked for: of an odd size, or transparent; and an --encoder
/// that has no frames to compress.
void note_film_differences(const std::vector<std::string>& names,
                           const PictureOptions& picture,
                           bool encoder_given,
                           Notes& notes);

/// Throws UsageError unless the name is that of a folder (it ends in / or is one) or has a film's
/// suffix, and OutputError where a film would have the name of a folder.
void require_picture_output(const std::string& name);

}  // namespace wuerfel
