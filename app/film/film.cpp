#include "app/film/film.h"

#include <utility>

#include <fmt/core.h>

#include "app/film/origin.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {

Film::Film(const PictureOptions& picture,
           const FrameRate& rate,
           const MotionSource& source,
           PictureOutputs& outputs)
    : picture_(picture), rate_(rate), source_(source), outputs_(outputs), recording_(source) {
  picture_.average = source.back.average;
  picture_.color_by = color_by(picture, source.scene.cubes.size());
}

void Film::open_pipeline() {
  fitted_ = fit_to_motion(picture_, recording_);
  fitted_.legend = legend_of(fitted_, recording_.seen());
  const std::string settings = fmt::format("{} --fps {} --speed {} {}", option_text(fitted_),
                                           rate_.fps, rate_.speed, option_text(source_.motion));
  pipeline_.emplace(PipelineSettings{make_style(fitted_.theme), frame_options(fitted_),
                                     origin_texts(settings, normalised_scene(source_.scene)),
                                     fitted_.encoder, fitted_.rasteriser},
                    outputs_.pipeline_outputs());
}

void Film::add(Snapshot snapshot) {
  ++frames_;
  if (needs_whole_motion(picture_)) {
    recording_.add(std::move(snapshot));
    return;
  }
  if (!pipeline_) {
    recording_.add(snapshot);
    open_pipeline();
  }
  draw(snapshot);
}

void Film::draw(const Snapshot& snapshot) {
  FrameJob job{snapshot, view_of(fitted_, snapshot), {time_text({snapshot.time})}};
  job.snapshot.revision = ++drawn_;  // what looks the same the pipeline finds out by itself
  if (fitted_.layers.has(Layer::trails)) {
    trails_.add(snapshot);
    job.snapshot.trails = trails_.paths();
  }
  pipeline_->add(std::move(job));
}

void Film::draw_recording(Progress::Style style) {
  Progress progress(style, "drawing", static_cast<double>(frames_), "frames");
  double done = 0.0;
  recording_.for_each([&](const Snapshot& snapshot) {
    source_.stop.check();
    draw(snapshot);
    progress.reached(done++);
  });
  pipeline_->finish();
  progress.reached(done);
}

void Film::finish(Progress::Style style) {
  if (frames_ == 0) return;
  if (pipeline_) {
    pipeline_->finish();
  } else {
    open_pipeline();
    draw_recording(style);
  }
  source_.stop.check();
  outputs_.finish();
}

}  // namespace wuerfel
