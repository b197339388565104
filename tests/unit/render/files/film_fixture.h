/// Films in a folder of their own, looked at with ffprobe and ffmpeg as any player would.
#pragma once

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

#include "render/files/animation.h"
#include "render/files/png.h"
#include "tests/support/own_folder.h"

namespace wuerfel::internal {

inline std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> output(popen(command.c_str(), "r"), pclose);
  std::string text;
  std::array<char, 256> part{};
  while (std::fgets(part.data(), static_cast<int>(part.size()), output.get()) != nullptr)
    text += part.data();
  while (!text.empty() && text.back() == '\n')
    text.pop_back();
  return text;
}

inline std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

class Film : public test::OwnFolder {
 protected:
  void SetUp() override {
    OwnFolder::SetUp();
    settings.width = 64;
    settings.height = 48;
    settings.fps = 25.0;
    settings.palette = animation_palette(make_style(Theme::light));
  }
  bool folder_is_empty() const { return std::filesystem::is_empty(folder); }

  /// A white picture in which a red bar moves to the right; half of it transparent where that is
  /// asked for.
  Image frame(int number) const {
    Image image(settings.width, settings.height,
                settings.transparent ? Color{0, 0, 0, 0} : rgb(0xFFFFFF));
    for (int y = 0; y < settings.height; ++y) {
      for (int x = 4 * number; x < 4 * number + 8; ++x)
        image.set(x, y, make_style(Theme::light).contact);
    }
    return image;
  }

  void write(const std::string& name, int frames) const {
    const auto writer = make_animation_writer(path(name), settings);
    for (int i = 0; i < frames; ++i)
      writer->add(frame(i));
    writer->finish();
  }

  std::string probe(const std::string& name, const std::string& entries) const {
    return output_of("ffprobe -v error -count_frames -show_entries stream=" + entries
                     + " -of csv=p=0 '" + path(name) + "'");
  }

  /// A frame as a viewer sees it.
  Image decoded(const std::string& name, int number, const std::string& decoder = "") const {
    const std::string picture = path("decoded.png");
    output_of("ffmpeg -v error -y " + decoder + " -i '" + path(name) + "' -vf select='eq(n\\,"
              + std::to_string(number) + ")' -frames:v 1 '" + picture + "'");
    return read_png(picture).image;
  }

  AnimationSettings settings;
};

}  // namespace wuerfel::internal
