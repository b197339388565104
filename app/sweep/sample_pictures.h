/// The pictures of a sample: first frame, masks and film, all seen from one place.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <thread>

#include "app/cli/stop_signal.h"
#include "app/film/picture_options.h"
#include "app/film/recording.h"
#include "app/sweep/sweep_file.h"
#include "core/scene/scene.h"
#include "core/snapshot.h"
#include "render/picture/style.h"
#include "render/raster/renderer.h"

namespace wuerfel {

/// One renderer for each thread that draws, kept between samples.
class Renderers {
 public:
  /// That of the calling thread.
  Renderer& mine();

 private:
  std::mutex mutex_;
  std::map<std::thread::id, std::unique_ptr<Renderer>> all_;
};

/// What pictures of one sample have in common. The view is that of the first frame, widened, so
/// that no picture tells what will happen.
class SamplePictures {
 public:
  SamplePictures(const Scene& scene,
                 const SampleFiles& files,
                 const Snapshot& first,
                 const StopSignal& stop,
                 Renderer& renderer);

  /// A PNG file that carries its origin, as those of `figure`.
  [[nodiscard]] std::string frame(const Snapshot& snapshot);
  /// PNG files of numbers: see instance_mask.h.
  /// @{
  [[nodiscard]] std::string instances(const Snapshot& snapshot) const;
  [[nodiscard]] std::string numbered(const Snapshot& snapshot,
                                     std::span<const std::uint16_t> numbers) const;
  /// @}
  /// The pixels of a film's frame, valid up to the next call.
  const Image& pixels(const Snapshot& snapshot);

 private:
  Renderer& renderer_;
  PictureOptions fitted_;
  Style style_;
  FrameOptions frame_;
  std::string scene_;
  Image image_;
};

/// How a sweep's pictures look.
PictureOptions picture_options(const SampleFiles& files);
/// Scales and view that fit the first frame of a scene alone.
PictureOptions fit_to_first(const PictureOptions& options,
                            const Scene& scene,
                            const Snapshot& first,
                            const StopSignal& stop);

}  // namespace wuerfel
