#include "app/sweep/sample_film.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

#include "render/error.h"

namespace wuerfel {

namespace {

std::string temporary_folder() {
  std::string name = (std::filesystem::temp_directory_path() / "wuerfel-film-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw OutputError(
        fmt::format("cannot write {}: {}", name, std::generic_category().message(errno)));
  }
  return name;
}

}  // namespace

SampleFilm::SampleFilm(const SampleFiles& files, const StopSignal& stop)
    : folder_(temporary_folder()) {
  AnimationSettings settings;
  settings.width = files.size.width;
  settings.height = files.size.height;
  settings.fps = *files.video;
  settings.while_waiting = [&stop] { stop.check(); };
  writer_ = make_animation_writer(folder_ + "/film.mp4", settings);
}

SampleFilm::~SampleFilm() {
  writer_.reset();
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

std::string SampleFilm::finish() {
  writer_->finish();
  const std::string path = folder_ + "/film.mp4";
  std::string bytes(std::filesystem::file_size(path), '\0');
  std::ifstream(path, std::ios::binary)
      .read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return bytes;
}

}  // namespace wuerfel
