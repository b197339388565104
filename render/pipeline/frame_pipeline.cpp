#include "render/pipeline/frame_pipeline.h"

#include <utility>

#include "render/picture/compose_frame.h"
#include "render/raster/renderer.h"

namespace wuerfel {

FramePipeline::FramePipeline(PipelineSettings settings, PipelineOutputs outputs)
    : settings_(std::move(settings)),
      outputs_(std::move(outputs)),
      all_texts_(text_chunks(settings_.texts)) {
  for (std::size_t slot = 0; slot < slots; ++slot)
    free_slots_.push(slot);
  drawing_ = std::thread([this] { run_guarded(&FramePipeline::draw_frames); });
  for (int i = 0; i < settings_.encoding_threads; ++i)
    encoding_.emplace_back([this] { run_guarded(&FramePipeline::encode_frames); });
}

FramePipeline::~FramePipeline() {
  close_queues();
  join();
}

/// What a thread throws is kept for the caller, and all queues are closed so that nobody waits for
/// it.
void FramePipeline::run_guarded(void (FramePipeline::*work)()) {
  try {
    (this->*work)();
  } catch (...) {
    {
      const std::scoped_lock lock(failure_mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
    close_queues();
  }
}

void FramePipeline::close_queues() {
  jobs_.close();
  drawn_.close();
  free_slots_.close();
  const std::scoped_lock lock(turn_mutex_);
  stopped_ = true;
  turn_changed_.notify_all();
}

void FramePipeline::join() {
  if (drawing_.joinable()) drawing_.join();
  for (std::thread& thread : encoding_) {
    if (thread.joinable()) thread.join();
  }
}

void FramePipeline::rethrow_failure() {
  const std::scoped_lock lock(failure_mutex_);
  if (failure_) std::rethrow_exception(failure_);
}

void FramePipeline::add(FrameJob job) {
  if (!jobs_.push(std::move(job))) rethrow_failure();
}

void FramePipeline::finish() {
  jobs_.close();
  join();
  rethrow_failure();
}

void FramePipeline::draw_frames() {
  Renderer renderer(RasterThreads::caller);
  const bool shows_time = settings_.options.layers.has(Layer::hud);
  DrawList last;
  std::optional<std::uint64_t> last_revision;
  View last_view;
  std::uint64_t number = 0;
  while (std::optional<FrameJob> job = jobs_.pop()) {
    Drawn frame{number++, std::nullopt, std::move(job->texts)};
    // Equal revisions differ in the time alone; equal lists are equal pictures.
    const bool known =
        !shows_time && last_revision == job->snapshot.revision && last_view == job->view;
    if (!known) {
      DrawList list = compose_frame(job->snapshot, job->view, settings_.style, settings_.options,
                                    renderer.font());
      if (!last_revision || list != last) {
        frame.slot = free_slots_.pop();
        if (!frame.slot) return;
        renderer.draw(list, images_.at(*frame.slot));
        last = std::move(list);
      }
      last_revision = job->snapshot.revision;
      last_view = job->view;
    }
    if (!frame.slot) ++reused_;
    if (!drawn_.push(std::move(frame))) return;
  }
  drawn_.close();
}

void FramePipeline::encode_frames() {
  const bool opaque = settings_.style.background.a == 255;
  const PngChannels channels = opaque ? PngChannels::rgb : PngChannels::rgba;
  CompressedImage compressed;
  while (const std::optional<Drawn> frame = drawn_.pop()) {
    if (frame->slot && outputs_.take_png)
      compress_image(images_.at(*frame->slot), settings_.encoder, channels, compressed);
    std::unique_lock turn(turn_mutex_);
    turn_changed_.wait(turn, [&] { return stopped_ || turn_ == frame->number; });
    if (stopped_) return;
    if (frame->slot) std::swap(compressed_, compressed);
    write_frame(*frame);
    if (frame->slot) free_slots_.push(*frame->slot);
    ++turn_;
    turn_changed_.notify_all();
  }
}

void FramePipeline::write_frame(const Drawn& frame) {
  for (AnimationWriter* film : outputs_.films) {
    if (frame.slot) {
      film->add(images_.at(*frame.slot));
    } else {
      film->repeat();
    }
  }
  if (!outputs_.take_png) return;
  std::vector<std::uint8_t> texts = text_chunks(frame.texts);
  texts.insert(texts.end(), all_texts_.begin(), all_texts_.end());
  assemble_png(compressed_, texts, file_);
  outputs_.take_png(file_);
}

}  // namespace wuerfel
