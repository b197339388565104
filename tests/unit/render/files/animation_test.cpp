// Films, looked at with ffprobe and ffmpeg as any player would.
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "render/error.h"
#include "tests/unit/render/files/film_fixture.h"

namespace wuerfel::internal {
namespace {

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
}  // namespace
}  // namespace wuerfel::internal
