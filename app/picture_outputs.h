/// All the places that frames go to.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/frame_folder.h"
#include "render/files/animation.h"
#include "render/pipeline/frame_pipeline.h"

namespace wuerfel {

class PictureOutputs {
 public:
  /// Folders and films by their names. Throws OutputError where one of them cannot be made or
  /// ffmpeg is missing, and UsageError where a film cannot have these settings.
  PictureOutputs(const std::vector<std::string>& names, const AnimationSettings& settings);

  [[nodiscard]] bool empty() const { return folders_.empty() && films_.empty(); }

  /// All of them as a pipeline wants them; valid as long as this object.
  PipelineOutputs pipeline_outputs();
  /// Completes all of them. Films appear only now. Throws OutputError.
  void finish();

 private:
  std::vector<std::unique_ptr<FrameFolder>> folders_;
  std::vector<std::unique_ptr<AnimationWriter>> films_;
};

/// Throws UsageError unless the name is that of a folder (it ends in / or is one) or has a film's
/// suffix.
void require_picture_output(const std::string& name);

}  // namespace wuerfel
