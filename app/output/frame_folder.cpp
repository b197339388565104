#include "app/output/frame_folder.h"

#include <cerrno>
#include <string>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <fmt/core.h>

#include "render/error.h"
#include "render/files/output_file.h"

namespace wuerfel {

namespace {

std::string frame_name(int number) { return fmt::format("frame_{:06}.png", number); }

}  // namespace

FrameFolder::FrameFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  made_ = std::filesystem::create_directories(folder_, error);
  if (error || !std::filesystem::is_directory(folder_, error)) {
    throw OutputError(
        fmt::format("cannot make the folder {}: {}", folder_.string(), error.message()));
  }
  if (::access(folder_.c_str(), W_OK | X_OK) != 0) {
    throw OutputError(fmt::format("cannot write into {}: {}", folder_.string(),
                                  std::generic_category().message(errno)));
  }
}

FrameFolder::~FrameFolder() {
  std::error_code ignored;
  if (made_ && count_ == 0) std::filesystem::remove(folder_, ignored);
}

void FrameFolder::add(std::span<const std::uint8_t> png) {
  // Frames of an earlier run would pass for later ones of this one, should it be interrupted.
  if (count_ == 0) {
    finish();
    remove_left_behind(folder_, "frame_");
  }
  OutputFile file((folder_ / frame_name(count_)).string(), true);
  file.write(png);
  file.commit();
  ++count_;
}

void FrameFolder::finish() {
  std::error_code ignored;
  for (int stale = count_; std::filesystem::remove(folder_ / frame_name(stale), ignored);)
    ++stale;
}

}  // namespace wuerfel
