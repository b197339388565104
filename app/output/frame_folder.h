/// A folder of numbered frames: frame_000000.png and so on.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

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

  /// Writes the next frame, the bytes of a PNG file, whole or not at all; with the first one those of
  /// an earlier run go. Throws OutputError.
  void add(std::span<const std::uint8_t> png);
  /// Removes frames after the last, which would pass for the end of this run.
  void finish();

 private:
  std::filesystem::path folder_;
  bool made_ = false;
  int count_ = 0;
};

}  // namespace wuerfel
