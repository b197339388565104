// What becomes of films when ffmpeg is missing, fails or hangs.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "render/error.h"
#include "render/files/child_process.h"
#include "tests/unit/render/files/film_fixture.h"

namespace wuerfel::internal {
namespace {

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

TEST_F(FakeFfmpeg, CostsTheThreadThatWaitsForIt) {
  install("i=0; while [ $i -lt 30000 ]; do i=$((i + 1)); done; cat > /dev/null; exit 3");
  double other = 0.0;
  const double before = cpu_of_children_of_thread();
  failure();
  std::jthread([&other] { other = cpu_of_children_of_thread(); }).join();
  EXPECT_GT(cpu_of_children_of_thread(), before);
  EXPECT_EQ(other, 0.0);
}

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
  const auto add_many = [&] {
    for (int i = 0; i < 20; ++i)
      writer->add(picture);
  };
  EXPECT_THROW(add_many(), Impatience);
}

TEST_F(FakeFfmpeg, GetsNothingThroughAShell) {
  const std::string name = "a'; touch injected; '.mp4";
  write(name, 2);
  EXPECT_TRUE(std::filesystem::exists(path(name)));
  EXPECT_FALSE(std::filesystem::exists("injected"));
}
}  // namespace
}  // namespace wuerfel::internal
