/// From a recorded run to pictures: one view, one force scale and one legend for all of them.
#pragma once

#include <string>
#include <vector>

#include "app/commands.h"
#include "app/recording.h"
#include "core/time/simulation.h"
#include "render/animation.h"
#include "render/frame_options.h"
#include "render/image.h"
#include "render/png.h"
#include "render/renderer.h"

namespace wuerfel {

/// What the layers need to know of the physics.
SnapshotRequest snapshot_request(Layers layers);

/// Draws the frames of one recording.
class Painter {
 public:
  /// Looks through the whole film first. Throws RenderError where nothing can be drawn.
  Painter(const Recording& film, const PictureOptions& options);

  /// The picture of frame `k`; valid until the next call. One that would be the same as the last is
  /// not drawn again.
  const Image& draw(std::size_t k);
  [[nodiscard]] long reused() const { return reused_; }

  /// The picture options, with fitted values in place of "fit", as they would be written on the
  /// command line.
  [[nodiscard]] std::string option_text() const;

 private:
  void fit_arrows();
  [[nodiscard]] View fit() const;

  const Recording& film_;
  PictureOptions options_;
  Style style_;
  FrameOptions frame_;
  View view_;
  Renderer renderer_;
  Image image_;
  bool drawn_ = false;
  std::uint64_t drawn_revision_ = 0;
  long reused_ = 0;
};

/// How a film of these pictures is encoded.
AnimationSettings animation_settings(const PictureOptions& options, double fps, const Scene& scene);

/// What a picture carries so that it can be made again: version, options, time and scene; no date,
/// path or host.
std::vector<PngText> origin(double time,
                            const std::string& options,
                            const std::string& normalised_scene);

/// The motion options as they would be written on the command line.
std::string option_text(const MotionSettings& motion);

}  // namespace wuerfel
