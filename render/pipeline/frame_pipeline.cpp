#include "render/pipeline/frame_pipeline.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

#include "render/error.h"
#include "render/picture/compose_frame.h"
#include "render/raster/renderer.h"

namespace wuerfel {

FramePipeline::FramePipeline(PipelineSettings settings, PipelineOutputs outputs)
    : settings_(std::move(settings)), outputs_(std::move(outputs)) {
  for (std::size_t slot = 0; slot < slots; ++slot)
    free_slots_.push(slot);
  start();
}

FramePipeline::~FramePipeline() {
  close_queues();
  join();
}

void FramePipeline::start() try {
  threads_[0] = std::thread([this] { run_guarded(&FramePipeline::draw_frames); });
  threads_[1] = std::thread([this] { run_guarded(&FramePipeline::encode_frames); });
} catch (const std::system_error& error) {
  close_queues();
  join();
  throw OutputError(std::string("cannot start a thread that draws: ") + error.what());
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
}

void FramePipeline::join() {
  for (std::thread& thread : threads_)
    if (thread.joinable()) thread.join();
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
  Renderer renderer(settings_.rasteriser);
  const bool shows_time = settings_.options.layers.has(Layer::hud);
  DrawList last;
  std::optional<std::uint64_t> last_revision;
  View last_view;
  while (std::optional<FrameJob> job = jobs_.pop()) {
    Drawn frame{std::nullopt, {}, std::move(job->texts)};
    // Equal revisions differ in the time alone; equal lists are equal pictures.
    const bool known =
        !shows_time && last_revision == job->snapshot.revision && last_view == job->view;
    if (!known) {
      DrawList list = compose_frame(job->snapshot, job->view, settings_.style, settings_.options,
                                    renderer.font());
      labels_left_out_ =
          std::max(labels_left_out_.load(), list.labels_left_out + list.legend_left_out);
      if (!last_revision || list != last) {
        frame.slot = free_slots_.pop();
        if (!frame.slot) return;
        frame.changed = draw(renderer, list, *frame.slot);
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

RowSet FramePipeline::draw(Renderer& renderer, const DrawList& list, std::size_t slot) {
  RowSet changed = renderer.draw(list, images_.at(slot), stale_.at(slot));
  stale_.at(slot) = RowSet();
  for (std::size_t other = 0; other < slots; ++other)
    if (other != slot && stale_.at(other)) stale_.at(other)->add(changed);
  return changed;
}

void FramePipeline::encode_frames() {
  const bool opaque = settings_.style.background.a == 255;
  const PngChannels channels = opaque ? PngChannels::rgb : PngChannels::rgba;
  const std::vector<std::uint8_t> all_texts = text_chunks(settings_.texts);
  std::optional<ImageCompressor> compressor;
  if (outputs_.take_png) compressor.emplace(settings_.encoder);
  CompressedImage compressed;  // the last picture
  std::vector<std::uint8_t> file;
  while (const std::optional<Drawn> frame = drawn_.pop()) {
    add_to_films(*frame);
    if (compressor) {
      if (frame->slot)
        compressor->compress(images_.at(*frame->slot), channels, compressed, frame->changed);
      std::vector<std::uint8_t> texts = text_chunks(frame->texts);
      texts.insert(texts.end(), all_texts.begin(), all_texts.end());
      assemble_png(compressed, texts, file);
      outputs_.take_png(file);
    }
    if (frame->slot) free_slots_.push(*frame->slot);
  }
}

void FramePipeline::add_to_films(const Drawn& frame) {
  for (AnimationWriter* film : outputs_.films) {
    if (frame.slot) {
      film->add(images_.at(*frame.slot));
    } else {
      film->repeat();
    }
  }
}

}  // namespace wuerfel
