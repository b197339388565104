#include "render/frame_pipeline.h"

#include <utility>

#include "render/compose_frame.h"
#include "render/renderer.h"

namespace wuerfel {

FramePipeline::FramePipeline(PipelineSettings settings, PipelineOutputs outputs)
    : settings_(std::move(settings)),
      outputs_(std::move(outputs)),
      all_texts_(text_chunks(settings_.texts)) {
  for (std::size_t slot = 0; slot < slots; ++slot)
    free_slots_.push(slot);
  drawing_ = std::thread([this] { run_guarded(&FramePipeline::draw_frames); });
  encoding_ = std::thread([this] { run_guarded(&FramePipeline::encode_frames); });
}

FramePipeline::~FramePipeline() { stop(); }

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
    jobs_.close();
    drawn_.close();
    free_slots_.close();
  }
}

void FramePipeline::stop() {
  jobs_.close();
  free_slots_.close();
  drawn_.close();
  if (drawing_.joinable()) drawing_.join();
  if (encoding_.joinable()) encoding_.join();
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
  if (drawing_.joinable()) drawing_.join();
  if (encoding_.joinable()) encoding_.join();
  rethrow_failure();
}

void FramePipeline::draw_frames() {
  Renderer renderer(RasterThreads::caller);
  const bool shows_time = settings_.options.layers.has(Layer::hud);
  DrawList last;
  std::optional<std::uint64_t> last_revision;
  View last_view;
  while (std::optional<FrameJob> job = jobs_.pop()) {
    Drawn frame{std::nullopt, std::move(job->texts)};
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
  std::optional<std::size_t> current;
  while (const std::optional<Drawn> frame = drawn_.pop()) {
    if (frame->slot) {
      if (current) free_slots_.push(*current);
      current = frame->slot;
    }
    write_frame(*frame, images_.at(*current));
  }
}

void FramePipeline::write_frame(const Drawn& frame, const Image& image) {
  for (AnimationWriter* film : outputs_.films) {
    if (frame.slot) {
      film->add(image);
    } else {
      film->repeat();
    }
  }
  if (!outputs_.take_png) return;
  if (frame.slot) {
    const bool opaque = settings_.style.background.a == 255;
    compressed_ =
        compress_image(image, settings_.encoder, opaque ? PngChannels::rgb : PngChannels::rgba);
  }
  std::vector<std::uint8_t> texts = text_chunks(frame.texts);
  texts.insert(texts.end(), all_texts_.begin(), all_texts_.end());
  assemble_png(compressed_, texts, file_);
  outputs_.take_png(file_);
}

}  // namespace wuerfel
