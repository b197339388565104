#include "app/film.h"

#include <utility>

#include <fmt/core.h>

#include "app/origin.h"
#include "app/progress.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {

Film::Film(const RunOptions& options, const Scene& scene, PictureOutputs& outputs)
    : options_(options),
      scene_(scene),
      outputs_(outputs),
      at_once_(!needs_whole_motion(options.picture)) {}

void Film::open_pipeline() {
  fitted_ = fit_to_motion(options_.picture, recording_);
  const std::string settings =
      fmt::format("{} --fps {} --speed {} {}", option_text(fitted_), options_.rate.fps,
                  options_.rate.speed, option_text(options_.motion));
  pipeline_.emplace(
      PipelineSettings{make_style(fitted_.theme), frame_options(fitted_),
                       origin_texts(settings, normalised_scene(scene_)), fitted_.encoder},
      outputs_.pipeline_outputs());
}

void Film::add(Snapshot snapshot) {
  ++frames_;
  if (!at_once_) {
    recording_.add(std::move(snapshot));
    return;
  }
  if (!pipeline_) {
    recording_.add(snapshot);
    open_pipeline();
  }
  revisions_.stamp(snapshot);
  draw(snapshot);
}

void Film::draw(const Snapshot& snapshot) {
  FrameJob job{snapshot, view_of(fitted_, snapshot), {time_text({snapshot.time})}};
  if (fitted_.layers.has(Layer::trails)) {
    trails_.add(snapshot);
    job.snapshot.trails = trails_.paths();
  }
  pipeline_->add(std::move(job));
}

void Film::draw_recording(const StopSignal& stop) {
  Progress progress(Progress::style_for_stderr(options_.quiet), "drawing",
                    static_cast<double>(frames_), "frames");
  Recording::Replay replay(recording_);
  double done = 0.0;
  for (Snapshot snapshot; replay.next(snapshot);) {
    stop.check();
    draw(snapshot);
    progress.reached(done++);
  }
  pipeline_->finish();
  progress.reached(done);
}

void Film::finish(const StopSignal& stop) {
  if (frames_ == 0) return;
  if (at_once_) {
    pipeline_->finish();
  } else {
    open_pipeline();
    draw_recording(stop);
  }
  stop.check();
  outputs_.finish();
}

}  // namespace wuerfel
