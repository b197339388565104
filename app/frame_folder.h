/// A folder of numbered frames: frame_000000.png and so on.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "render/image.h"
#include "render/png.h"

namespace wuerfel {

class FrameFolder {
 public:
  /// Makes the folder where it is missing. Throws OutputError where that fails or nothing can be
  /// written into it.
  explicit FrameFolder(std::filesystem::path folder);
  /// Removes a folder that was made here and is still empty.
  ~FrameFolder();
  FrameFolder(const FrameFolder&) = delete;
  FrameFolder& operator=(const FrameFolder&) = delete;

  /// Writes the next frame, whole or not at all. Throws OutputError.
  void add(const Image& image, std::span<const PngText> texts);
  /// Removes frames of an earlier, longer run, which would pass for the end of this one.
  void finish();

 private:
  std::filesystem::path folder_;
  bool made_ = false;
  int count_ = 0;
};

}  // namespace wuerfel
