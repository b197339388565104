/// From the frames of a run to pictures: one view, one force scale and one legend for all of them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/commands.h"
#include "app/picture_outputs.h"
#include "app/recording.h"
#include "app/stop_signal.h"
#include "app/trails.h"
#include "render/pipeline/frame_pipeline.h"

namespace wuerfel {

/// Draws while the simulation goes on where view and scales are given; else keeps the motion and
/// draws when its end is known. Either way drawing and encoding have a thread each, memory holds a
/// few frames, and without a frame nothing is set up.
class Film {
 public:
  /// `outputs` lives longer than the film.
  Film(const RunOptions& options, const Scene& scene, PictureOutputs& outputs);

  /// The next frame. Throws OutputError and RenderError.
  void add(Snapshot snapshot);
  /// Draws what is left and completes the outputs. Throws the same, and Interrupted.
  void finish(const StopSignal& stop);

  [[nodiscard]] long frames() const { return frames_; }
  /// Frames that were neither drawn nor compressed again.
  [[nodiscard]] long reused() const { return pipeline_ ? pipeline_->reused() : 0; }

 private:
  void open_pipeline();
  void draw(const Snapshot& snapshot);
  void draw_recording(const StopSignal& stop);

  const RunOptions& options_;
  const Scene& scene_;
  PictureOutputs& outputs_;
  bool at_once_;
  Recording recording_;  // of all frames, or of the first where the others are drawn at once
  Revisions revisions_;
  Trails trails_;
  PictureOptions fitted_;
  std::optional<FramePipeline> pipeline_;
  long frames_ = 0;
};

}  // namespace wuerfel
