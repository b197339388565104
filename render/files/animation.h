/// Animations: frames in, one film out.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "render/picture/color.h"
#include "render/picture/style.h"
#include "render/raster/image.h"

namespace wuerfel {

class AnimationWriter {
 public:
  AnimationWriter() = default;
  /// Without `finish` before, nothing of the film remains.
  virtual ~AnimationWriter() = default;
  AnimationWriter(const AnimationWriter&) = delete;
  AnimationWriter& operator=(const AnimationWriter&) = delete;
  AnimationWriter(AnimationWriter&&) = delete;
  AnimationWriter& operator=(AnimationWriter&&) = delete;

  /// The next frame; it is shown for 1/fps. Throws OutputError where the film cannot be written,
  /// and RenderError where the frame has another size than was said.
  virtual void add(const Image& frame) = 0;
  /// The last frame once more, without converting or compressing it again. Only after `add`.
  virtual void repeat() = 0;
  /// Completes the film, which only now gets its name. Throws OutputError.
  virtual void finish() = 0;
};

struct AnimationSettings {
  int width = 1280;
  int height = 720;
  double fps = 60.0;
  /// Keep the alpha channel (webm, apng, gif with on/off transparency); mp4 has none and shows
  /// white instead.
  bool transparent = false;
  /// Colours of the frames, for GIF; see animation_palette. Empty: chosen from each frame, which
  /// takes longer.
  std::vector<Color> palette;
  /// Called ten times a second while ffmpeg keeps us waiting; may throw to give up. It runs in the
  /// thread that adds frames.
  std::function<void()> while_waiting = {};
};

/// By the suffix of `path`: .mp4 (H.264), .webm (VP9), .gif, .apng; mp4, webm and gif need ffmpeg
/// on the PATH. Equal frames give equal bytes. Throws RenderError on another suffix and OutputError
/// where ffmpeg does not start or the folder cannot be written.
std::unique_ptr<AnimationWriter> make_animation_writer(const std::string& path,
                                                       const AnimationSettings& settings);

/// True where make_animation_writer knows the suffix.
bool is_animation_path(const std::string& path);

/// At most 255 colours that pictures in this style are made of: fills, lines, arrows and their
/// antialiased edges. `bodies` are colours that the scene asks for.
std::vector<Color> animation_palette(const Style& style, const std::vector<Color>& bodies = {});

}  // namespace wuerfel
