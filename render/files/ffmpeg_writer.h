/// FfmpegWriter: films through an ffmpeg process that reads our frames from its standard input.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "render/files/animation.h"
#include "render/files/child_process.h"
#include "render/files/output_file.h"

namespace wuerfel::internal {

enum class FilmFormat { mp4, webm, gif };

/// Opaque video is sent as YUV (y4m, converted here: half the bytes and a third of ffmpeg's time),
/// GIF and video with alpha as RGBA. Memory does not grow with the number of frames.
class FfmpegWriter final : public AnimationWriter {
 public:
  FfmpegWriter(const std::string& path, FilmFormat format, const AnimationSettings& settings);
  void add(const Image& frame) override;
  void repeat() override;
  void finish() override;

 private:
  [[noreturn]] void fail();
  AnimationSettings settings_;
  bool yuv_;
  OutputFile output_;
  std::optional<OutputFile> palette_;  ///< a picture for ffmpeg to read, removed at the end
  std::optional<ChildProcess> ffmpeg_;
  std::vector<std::uint8_t> last_frame_;  ///< as it was sent
};

}  // namespace wuerfel::internal
