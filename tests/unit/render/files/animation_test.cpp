// Films, looked at with ffprobe and ffmpeg as any player would.
#include "render/files/animation.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <unistd.h>

#include <gtest/gtest.h>

#include "render/error.h"
#include "render/files/child_process.h"
#include "render/files/png.h"
#include "tests/support/own_folder.h"

namespace wuerfel::internal {
namespace {

std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> output(popen(command.c_str(), "r"), pclose);
  std::string text;
  std::array<char, 256> part{};
  while (std::fgets(part.data(), static_cast<int>(part.size()), output.get()) != nullptr)
    text += part.data();
  while (!text.empty() && text.back() == '\n')
    text.pop_back();
  return text;
}

std::string bytes_of(const std::string& path) {
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

TEST_F(Film, Mp4HasSizeRateFramesAndColourTags) {
  write("a.mp4", 10);
  EXPECT_EQ(
      probe("a.mp4",
            "codec_name,width,height,pix_fmt,color_range,color_space,r_frame_rate,nb_read_frames"),
      "h264,64,48,yuv420p,tv,bt709,25/1,10");
}

TEST_F(Film, Mp4CanBePlayedBeforeItIsLoaded) {
  write("a.mp4", 3);
  const std::string bytes = bytes_of(path("a.mp4"));
  EXPECT_LT(bytes.find("moov"), bytes.find("mdat"));
}

TEST_F(Film, OddSizesArePaddedToEvenOnes) {
  settings.width = 63;
  settings.height = 47;
  write("a.mp4", 3);
  EXPECT_EQ(probe("a.mp4", "width,height"), "64,48");
}

TEST_F(Film, WebmHasSizeAndFrames) {
  write("a.webm", 10);
  EXPECT_EQ(probe("a.webm", "codec_name,width,height,color_space,nb_read_frames"),
            "vp9,64,48,bt709,10");
}

TEST_F(Film, TransparentWebmKeepsItsAlpha) {
  settings.transparent = true;
  write("a.webm", 4);
  const Image image = decoded("a.webm", 2, "-c:v libvpx-vp9");
  EXPECT_LT(image.at(50, 24).a, 20);
  EXPECT_GT(image.at(11, 24).a, 235);
}

TEST_F(Film, TransparentMp4IsShownOnWhite) {
  settings.transparent = true;
  write("a.mp4", 4);
  EXPECT_GT(brightness(decoded("a.mp4", 0).at(50, 24)), 0.97);
}

TEST_F(Film, GifHasSizeFramesAndExactPaletteColours) {
  write("a.gif", 10);
  EXPECT_EQ(probe("a.gif", "codec_name,width,height,nb_read_frames"), "gif,64,48,10");
  const Image image = decoded("a.gif", 5);
  EXPECT_EQ(image.at(24, 24), make_style(Theme::light).contact);
  EXPECT_EQ(image.at(50, 24), rgb(0xFFFFFF));
}

TEST_F(Film, GifWithoutPaletteChoosesItsColours) {
  settings.palette.clear();
  write("a.gif", 4);
  const Color color = decoded("a.gif", 2).at(11, 24);
  EXPECT_NEAR(color.r, make_style(Theme::light).contact.r, 8);
}

TEST_F(Film, GifFasterThanViewersShowIsAnError) {
  settings.fps = 60.0;
  EXPECT_THROW(make_animation_writer(path("a.gif"), settings), RenderError);
  EXPECT_TRUE(folder_is_empty());
}

TEST_F(Film, ApngIsLosslessAndKnowsItsFrames) {
  write("a.apng", 10);
  EXPECT_EQ(probe("a.apng", "codec_name,width,height,nb_read_frames"), "apng,64,48,10");
  for (const int number : {0, 7})
    EXPECT_EQ(decoded("a.apng", number), frame(number)) << number;
  EXPECT_EQ(read_png(path("a.apng")).image, frame(0)) << "other viewers see the first frame";
}

TEST_F(Film, ApngKeepsAlpha) {
  settings.transparent = true;
  write("a.apng", 3);
  EXPECT_EQ(decoded("a.apng", 2), frame(2));
}

TEST_F(Film, EqualFramesGiveEqualBytes) {
  for (const std::string suffix : {".mp4", ".webm", ".gif", ".apng"}) {
    write("a" + suffix, 6);
    write("b" + suffix, 6);
    EXPECT_EQ(bytes_of(path("a" + suffix)), bytes_of(path("b" + suffix))) << suffix;
  }
}

TEST_F(Film, RepeatedFrameIsShownAgain) {
  for (const std::string name : {"a.mp4", "a.webm", "a.gif", "a.apng"}) {
    const auto writer = make_animation_writer(path(name), settings);
    writer->add(frame(0));
    writer->add(frame(3));
    writer->repeat();
    writer->repeat();
    writer->add(frame(6));
    writer->finish();
    EXPECT_EQ(probe(name, "nb_read_frames"), "5") << name;
    const Color color = decoded(name, 3).at(16, 24);
    EXPECT_NEAR(color.r, make_style(Theme::light).contact.r, 12) << name;
    EXPECT_NEAR(decoded(name, 4).at(16, 24).g, 255, 12) << name;
  }
}

TEST_F(Film, WithoutFinishNothingRemains) {
  for (const char* name : {"a.mp4", "a.webm", "a.gif", "a.apng"}) {
    const auto writer = make_animation_writer(path(name), settings);
    writer->add(frame(0));
  }
  EXPECT_TRUE(folder_is_empty());
}

TEST_F(Film, FrameOfAnotherSizeIsAnError) {
  for (const char* name : {"a.mp4", "a.apng"}) {
    const auto writer = make_animation_writer(path(name), settings);
    EXPECT_THROW(writer->add(Image(10, 10)), RenderError);
  }
}

TEST_F(Film, UnknownSuffixIsAnErrorThatListsTheKnownOnes) {
  EXPECT_FALSE(is_animation_path("a.avi"));
  EXPECT_THROW(make_animation_writer(path("a.avi"), settings), RenderError);
}

TEST_F(Film, FolderThatCannotBeWrittenIsAnError) {
  std::ofstream(path("file")) << "in the way";
  EXPECT_THROW(make_animation_writer(path("file/a.mp4"), settings), OutputError);
}

/// An ffmpeg of our own on the PATH, which behaves as `script` says.
class FakeFfmpeg : public Film {
 protected:
  void install(const std::string& script) {
    std::filesystem::create_directories(folder / "bin");
    const std::string program = path("bin/ffmpeg");
    std::ofstream(program) << "#!/bin/sh\n" << script << '\n';
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    setenv("PATH", (path("bin") + ":" + real_path).c_str(), 1);
  }
  void SetUp() override {
    Film::SetUp();
    real_path = std::getenv("PATH");
  }
  void TearDown() override {
    setenv("PATH", real_path.c_str(), 1);
    Film::TearDown();
  }
  /// The message of the error that comes up while frames are added and the film is finished.
  std::string failure() {
    try {
      const auto writer = make_animation_writer(path("a.mp4"), settings);
      for (int i = 0; i < 2000; ++i)
        writer->add(frame(i % 10));
      writer->finish();
    } catch (const OutputError& error) {
      return error.what();
    }
    return "no error";
  }
  std::string real_path;
};

TEST_F(FakeFfmpeg, MissingIsAnErrorThatSaysWhatToInstall) {
  setenv("PATH", path("nowhere").c_str(), 1);
  EXPECT_EQ(failure(), "ffmpeg was not found on the PATH; on Debian: apt install ffmpeg");
}

TEST_F(FakeFfmpeg, ThatStopsReadingIsAnErrorWithItsOwnWords) {
  install("echo 'no room left' >&2; exit 3");
  const std::string message = failure();
  EXPECT_NE(message.find("no room left"), std::string::npos) << message;
  EXPECT_FALSE(std::filesystem::exists(path("a.mp4")));
}

TEST_F(FakeFfmpeg, ThatFailsAtTheEndIsAnErrorToo) {
  install("cat > /dev/null; exit 1");
  EXPECT_NE(failure().find("ffmpeg failed"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(path("a.mp4")));
}

/// Thrown by who gives up.
struct Impatience {};

/// Gives up at the third call.
std::function<void()> short_patience() {
  return [calls = 0]() mutable {
    if (++calls == 3) throw Impatience();
  };
}

TEST_F(FakeFfmpeg, ThatNeverEndsIsGivenUpAndLeavesNothing) {
  install("echo $$ > " + path("bin/pid") + "; cat > /dev/null; exec sleep 1000");
  settings.while_waiting = short_patience();
  {
    const auto writer = make_animation_writer(path("a.mp4"), settings);
    writer->add(frame(0));
    EXPECT_THROW(writer->finish(), Impatience);
  }
  std::filesystem::remove_all(path("bin/ffmpeg"));
  EXPECT_EQ(output_of("ls -A " + folder.string()), "bin");
  EXPECT_EQ(output_of("kill -0 $(cat " + path("bin/pid") + ") 2>&1 && echo alive").find("alive"),
            std::string::npos);
}

TEST_F(FakeFfmpeg, ThatNeverReadsIsGivenUp) {
  install("exec sleep 1000");
  settings.width = 1920;
  settings.height = 1080;
  settings.while_waiting = short_patience();
  const auto writer = make_animation_writer(path("a.mp4"), settings);
  const Image picture(settings.width, settings.height);
  EXPECT_THROW(
      {
        for (int i = 0; i < 20; ++i)
          writer->add(picture);
      },
      Impatience);
}

TEST_F(FakeFfmpeg, GetsNothingThroughAShell) {
  const std::string name = "a'; touch injected; '.mp4";
  write(name, 2);
  EXPECT_TRUE(std::filesystem::exists(path(name)));
  EXPECT_FALSE(std::filesystem::exists("injected"));
}

}  // namespace
}  // namespace wuerfel::internal
