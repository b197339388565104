/// FramePipeline: simulate | draw | encode and write, each in a thread of its own, joined by short
/// queues.
#pragma once

#include <array>
#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "core/snapshot.h"
#include "render/files/animation.h"
#include "render/files/png.h"
#include "render/picture/frame_options.h"
#include "render/picture/style.h"
#include "render/picture/view.h"
#include "render/pipeline/bounded_queue.h"
#include "render/raster/image.h"
#include "render/raster/rasteriser.h"
#include "render/raster/row_set.h"

namespace wuerfel {

class Renderer;
struct DrawList;

/// What is the same for all frames.
struct PipelineSettings {
  Style style;
  FrameOptions options;
  std::vector<PngText> texts;  ///< of every PNG; compressed once
  PngEncoder encoder = PngEncoder::isa_l;
  Rasteriser rasteriser = Rasteriser::scan_lines;
};

/// What is to be drawn, how it is looked at, and what its PNG says of it.
struct FrameJob {
  Snapshot snapshot;
  View view;
  std::vector<PngText> texts;
};

/// Where frames go. Called from one thread at a time, in the order of the frames.
struct PipelineOutputs {
  std::function<void(std::span<const std::uint8_t>)>
      take_png;  ///< a whole PNG file per frame; empty: none wanted
  std::vector<AnimationWriter*>
      films;  ///< outlive the pipeline; finishing them is left to their owner
};

/// The thread that adds frames simulates; a second one draws, a third one encodes and writes.
/// Pictures are drawn into one of a few images and encoded from there: nothing is copied, and
/// memory does not grow with their number. A frame that looks like the one before is neither drawn
/// nor compressed again.
class FramePipeline {
 public:
  /// Throws OutputError where the threads cannot be started.
  FramePipeline(PipelineSettings settings, PipelineOutputs outputs);
  /// Drops what is under way if `finish` was not called.
  ~FramePipeline();
  FramePipeline(const FramePipeline&) = delete;
  FramePipeline& operator=(const FramePipeline&) = delete;
  FramePipeline(FramePipeline&&) = delete;
  FramePipeline& operator=(FramePipeline&&) = delete;

  /// The next frame. Waits while the queue is full. Throws what drawing or writing an earlier frame
  /// threw.
  void add(FrameJob job);
  /// Waits until all frames are written. Throws what went wrong; then some of the frames are
  /// missing.
  void finish();
  /// Frames that were neither drawn nor compressed again.
  long reused() const { return reused_; }
  /// The most labels for which a frame had no room.
  int labels_left_out() const { return labels_left_out_; }

 private:
  struct Drawn {
    std::optional<std::size_t> slot;  ///< of the picture; nothing: as before
    RowSet changed;                   ///< all else is as before
    std::vector<PngText> texts;
  };

  void start();
  void draw_frames();
  RowSet draw(Renderer& renderer, const DrawList& list, std::size_t slot);
  void encode_frames();
  void add_to_films(const Drawn& frame);
  void close_queues();
  void join();
  void run_guarded(void (FramePipeline::*work)());
  void rethrow_failure();

  PipelineSettings settings_;
  PipelineOutputs outputs_;
  static constexpr std::size_t slots = 3;  ///< one being drawn, one being encoded, one waiting
  std::array<Image, slots> images_;
  std::array<std::optional<RowSet>, slots>
      stale_;  ///< what is not as in the last picture; nothing: all
  internal::BoundedQueue<FrameJob> jobs_{4};
  internal::BoundedQueue<Drawn> drawn_{slots};
  internal::BoundedQueue<std::size_t> free_slots_{slots};
  std::atomic<long> reused_ = 0;
  std::atomic<int> labels_left_out_ = 0;
  std::mutex failure_mutex_;
  std::exception_ptr failure_;
  std::array<std::thread, 2> threads_;
};

}  // namespace wuerfel
