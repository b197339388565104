#include "render/files/png.h"

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "render/error.h"
#include "render/files/output_file.h"
#include "render/files/png_chunks.h"
#include "tests/support/own_folder.h"

namespace wuerfel::internal {
namespace {

/// Different in every pixel and channel.
Image gradient(int width, int height, bool opaque) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.set(
          x, y,
          {static_cast<std::uint8_t>(7 * x), static_cast<std::uint8_t>(13 * y),
           static_cast<std::uint8_t>(x * y), static_cast<std::uint8_t>(opaque ? 255 : x + y)});
    }
  }
  return image;
}

class PngFiles : public test::OwnFolder {
 protected:
  bool empty() const { return std::filesystem::is_empty(folder); }
};

TEST(Png, OpaquePictureComesBackPixelByPixel) {
  const Image image = gradient(37, 23, true);
  EXPECT_EQ(decode_png(encode_png(image)).image, image);
}

TEST(Png, TransparentPictureComesBackPixelByPixel) {
  const Image image = gradient(37, 23, false);
  EXPECT_EQ(decode_png(encode_png(image)).image, image);
}

TEST(Png, OpaquePictureIsWrittenWithoutAlpha) {
  constexpr std::size_t color_type_at = 25;
  EXPECT_EQ(encode_png(gradient(8, 8, true))[color_type_at], 2);
  EXPECT_EQ(encode_png(gradient(8, 8, false))[color_type_at], 6);
}

TEST(Png, TextsComeBackWhateverTheyHold) {
  const std::vector<PngText> texts{{"Title", "plain"},
                                   {"Empty", ""},
                                   {"Scene", std::string(5000, 'x') + "\n[[cube]]\n"},
                                   {"Name", "Würfel – 立方体"},
                                   {"Long", std::string(600, 'y') + "ü"}};
  EXPECT_EQ(decode_png(encode_png(Image(3, 2), texts)).texts, texts);
}

TEST(Png, LongTextsAreCompressed) {
  const std::vector<PngText> texts{{"Scene", std::string(100000, 'x')}};
  EXPECT_LT(encode_png(Image(3, 2), texts).size(), 2000U);
}

TEST(Png, SamePictureGivesTheSameBytes) {
  const std::vector<PngText> texts{{"Time", "1.25"}};
  EXPECT_EQ(encode_png(gradient(50, 40, true), texts), encode_png(gradient(50, 40, true), texts));
}

TEST(Png, HasNoDateAndNothingElseThatWasNotAskedFor) {
  const std::vector<std::uint8_t> file = encode_png(gradient(50, 40, true));
  for (const PngChunk& chunk : png_chunks(file)) {
    EXPECT_TRUE(chunk.type == "IHDR" || chunk.type == "IDAT" || chunk.type == "IEND") << chunk.type;
  }
}

TEST(Png, DamagedDataAreErrors) {
  const std::vector<std::uint8_t> good = encode_png(gradient(20, 20, true));
  EXPECT_THROW(decode_png({}), RenderError);
  for (const std::size_t length :
       {std::size_t{4}, std::size_t{20}, std::size_t{40}, good.size() - 14}) {
    EXPECT_THROW(decode_png({good.data(), length}), RenderError) << length;
  }
  std::vector<std::uint8_t> bad = good;
  bad[good.size() / 2] ^= 0x55U;
  EXPECT_THROW(decode_png(bad), RenderError);
}

TEST(Png, TextsOfManyMegabytesComeBack) {
  // libpng drops what is longer than 8 000 000 bytes.
  std::string scene;
  while (scene.size() < 9000000)
    scene += "{\"name\": \"cube" + std::to_string(scene.size()) + "\"}, ";
  const std::vector<PngText> texts{{"Scene", scene}};
  EXPECT_EQ(decode_png(encode_png(Image(3, 2), texts)).texts, texts);
}

/// A picture of one pixel with chunks put in before it.
std::vector<std::uint8_t> with_chunks(const std::vector<std::uint8_t>& chunks) {
  constexpr std::size_t header_end = 33;
  std::vector<std::uint8_t> file = encode_png(Image(1, 1));
  file.insert(file.begin() + header_end, chunks.begin(), chunks.end());
  return file;
}

TEST(Png, TextsThatUnpackToGigabytesAreErrors) {
  const std::vector<PngText> bomb{{"Bomb", std::string(std::size_t{16} << 20U, 'x')}};
  const std::vector<std::uint8_t> chunk = text_chunks(bomb);
  std::vector<std::uint8_t> chunks;
  for (int i = 0; i < 20; ++i)
    chunks.insert(chunks.end(), chunk.begin(), chunk.end());
  EXPECT_THROW(decode_png(with_chunks(chunks)), RenderError);
}

TEST(Png, SizesWithoutTheDataForThemAreErrors) {
  std::vector<std::uint8_t> file = encode_png(Image(1, 1));
  std::vector<std::uint8_t> header;
  append_u32(16384, header);
  append_u32(16384, header);
  header.insert(header.end(), {8, 2, 0, 0, 0});
  std::vector<std::uint8_t> chunk;
  append_chunk("IHDR", header, chunk);
  std::copy(chunk.begin(), chunk.end(), file.begin() + png_signature.size());
  EXPECT_THROW(decode_png(file), RenderError);
}

TEST(Png, TextsHoldNothingThatATerminalObeys) {
  const std::string hostile = "wuerfel \x1b[2J\x07\xff 0.1\n";
  std::vector<std::uint8_t> data{'S', 'o', 'f', 't', 'w', 'a', 'r', 'e', 0};
  data.insert(data.end(), hostile.begin(), hostile.end());
  std::vector<std::uint8_t> chunks;
  append_chunk("tEXt", data, chunks);
  const PngFile file = decode_png(with_chunks(chunks));
  ASSERT_EQ(file.texts.size(), 1U);
  EXPECT_EQ(file.texts[0].key, "Software");
  EXPECT_EQ(file.texts[0].value, "wuerfel \uFFFD[2J\uFFFD\uFFFD 0.1\n");
}

TEST(Png, DamagedTextsAreErrors) {
  for (const auto& [type, text] :
       std::vector<std::pair<std::string, std::string>>{{"tEXt", "no end of the key"},
                                                        {"zTXt", std::string("Key\0\0no zlib", 12)},
                                                        {"zTXt", std::string("Key\0\x01", 5)},
                                                        {"iTXt", std::string("Key\0", 4)},
                                                        {"iTXt", std::string("Key\0\0\0de", 8)}}) {
    std::vector<std::uint8_t> chunks;
    append_chunk(type, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, chunks);
    EXPECT_THROW(decode_png(with_chunks(chunks)), RenderError) << type << ' ' << text;
  }
}

TEST_F(PngFiles, AreWrittenWithTheirFoldersAndReadBack) {
  const Image image = gradient(20, 10, true);
  write_png(path("a/b/c.png"), image);
  EXPECT_EQ(read_png(path("a/b/c.png")).image, image);
}

TEST_F(PngFiles, MissingFileIsAnErrorThatNamesIt) {
  try {
    read_png(path("none.png"));
    FAIL();
  } catch (const RenderError& error) {
    EXPECT_NE(std::string(error.what()).find("none.png"), std::string::npos);
  }
}

TEST_F(PngFiles, ThatCannotBeWrittenAreErrorsWithTheReason) {
  std::ofstream(path("file")) << "in the way";
  EXPECT_THROW(write_png(path("file/frame.png"), Image(2, 2)), OutputError);
  try {
    write_png("/proc/none/frame.png", Image(2, 2));
    FAIL();
  } catch (const OutputError& error) {
    EXPECT_NE(std::string(error.what()).find("/proc/none"), std::string::npos) << error.what();
  }
}

TEST_F(PngFiles, FullDiskIsAnErrorAndLeavesNothing) {
  // No file may grow beyond 1000 bytes: what a full disk looks like from inside.
  const std::string target = path("big.png");
  const pid_t child = fork();
  if (child == 0) {
    struct rlimit limit {
      1000, 1000
    };
    setrlimit(RLIMIT_FSIZE, &limit);
    signal(SIGXFSZ, SIG_IGN);
    int status = 1;
    try {
      write_png(target, gradient(200, 200, true));
    } catch (const OutputError&) {
      status = 0;
    }
    _exit(status);
  }
  int status = 1;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(empty());
}

TEST_F(PngFiles, AppearOnlyWhenComplete) {
  {
    OutputFile file(path("half.png"));
    file.write(encode_png(Image(2, 2)));
    EXPECT_FALSE(std::filesystem::exists(path("half.png")));
  }
  EXPECT_TRUE(empty());
}

TEST_F(PngFiles, HaveTemporaryNamesThatNobodyForesees) {
  const OutputFile first(path("a.png"));
  const OutputFile second(path("a.png"));
  EXPECT_NE(first.temporary_path(), second.temporary_path());
  const std::string name = std::filesystem::path(first.temporary_path()).filename().string();
  EXPECT_EQ(name.find("." + std::to_string(getpid()) + "."), std::string::npos) << name;
}

TEST_F(PngFiles, DoNotReplaceWhatIsNoFile) {
  ASSERT_EQ(mkfifo(path("pipe.png").c_str(), 0600), 0);
  std::filesystem::create_directory(path("folder.png"));
  EXPECT_THROW(write_png(path("pipe.png"), Image(2, 2)), OutputError);
  EXPECT_THROW(write_png(path("folder.png"), Image(2, 2)), OutputError);
  EXPECT_TRUE(std::filesystem::is_fifo(path("pipe.png")));
  EXPECT_TRUE(std::filesystem::is_empty(path("folder.png")));
  EXPECT_THROW(read_png(path("folder.png")), RenderError);
}

TEST_F(PngFiles, ReplaceOlderOnes) {
  write_png(path("frame.png"), Image(2, 2, rgb(0x112233)));
  write_png(path("frame.png"), Image(3, 3, rgb(0x445566)));
  EXPECT_EQ(read_png(path("frame.png")).image, Image(3, 3, rgb(0x445566)));
}

}  // namespace
}  // namespace wuerfel::internal
