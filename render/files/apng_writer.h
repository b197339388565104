/// ApngWriter: animated PNG, lossless and without ffmpeg. The frames are ordinary PNG data in
/// chunks of their own (https://wiki.mozilla.org/APNG_Specification); libpng here knows nothing of
/// them.
#pragma once

#include <cstdint>
#include <string>

#include "render/files/animation.h"
#include "render/files/output_file.h"
#include "render/files/png.h"

namespace wuerfel::internal {

class ApngWriter final : public AnimationWriter {
 public:
  ApngWriter(const std::string& path, const AnimationSettings& settings);
  void add(const Image& frame) override;
  void repeat() override;
  void finish() override;

 private:
  void begin();
  void add_control(int width, int height);
  void add_data(const CompressedImage& image);
  AnimationSettings settings_;
  OutputFile output_;
  std::uint32_t frames_ = 0;
  std::uint32_t sequence_ = 0;  ///< of control and data chunks
  ImageCompressor compressor_;
  CompressedImage frame_;
  CompressedImage
      corner_;  ///< the upper left pixel of the last frame: drawing it again changes nothing
  std::vector<std::uint8_t> buffer_;
};

}  // namespace wuerfel::internal
