/// From the frames of a run to pictures: one view, one force scale and one legend for all of them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/cli/progress.h"
#include "app/film/picture_options.h"
#include "app/film/recording.h"
#include "app/film/timetable.h"
#include "app/film/trails.h"
#include "app/output/picture_outputs.h"
#include "render/pipeline/frame_pipeline.h"

namespace wuerfel {

/// Draws while the simulation goes on where view and scales are given; else keeps the motion and
/// draws when its end is known. Either way drawing and encoding have a thread each, memory is
/// bounded (see Recording), and without a frame nothing is set up.
class Film {
 public:
  /// Everything told lives longer than the film.
  Film(const PictureOptions& picture,
       const FrameRate& rate,
       const MotionSource& source,
       PictureOutputs& outputs);

  /// The next frame. Throws OutputError, RenderError, Interrupted.
  void add(Snapshot snapshot);
  /// Draws what is left and completes the outputs. Throws the same, and Interrupted.
  void finish(Progress::Style style);

  [[nodiscard]] long frames() const { return frames_; }
  /// Frames that were neither drawn nor compressed again.
  [[nodiscard]] long reused() const { return pipeline_ ? pipeline_->reused() : 0; }
  /// The most labels for which a frame had no room.
  [[nodiscard]] int labels_left_out() const { return pipeline_ ? pipeline_->labels_left_out() : 0; }

 private:
  void open_pipeline();
  void draw(const Snapshot& snapshot);
  void draw_recording(Progress::Style style);

  PictureOptions picture_;
  const FrameRate& rate_;
  const MotionSource& source_;
  PictureOutputs& outputs_;
  Recording recording_;  // of all frames, or of the first where the others are drawn at once
  Trails trails_;
  PictureOptions fitted_;
  std::optional<FramePipeline> pipeline_;
  long frames_ = 0;
  std::uint64_t drawn_ = 0;
};

}  // namespace wuerfel
