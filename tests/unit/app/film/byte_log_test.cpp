#include "app/film/byte_log.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <numeric>

#include <gtest/gtest.h>

#include "render/error.h"

namespace wuerfel {
namespace {

std::vector<std::uint8_t> numbered(std::size_t count) {
  std::vector<std::uint8_t> bytes(count);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
  return bytes;
}

/// What a log of this much memory gives back of 1000 bytes that came in pieces of 7.
std::vector<std::uint8_t> through_log(std::size_t in_memory) {
  ByteLog log(in_memory);
  const std::vector<std::uint8_t> bytes = numbered(1000);
  for (std::size_t at = 0; at < bytes.size(); at += 7)
    log.append(std::span(bytes).subspan(at, std::min<std::size_t>(7, bytes.size() - at)));
  std::vector<std::uint8_t> back(bytes.size());
  for (std::size_t at = 0; at < back.size(); at += 11)
    log.read(at, std::span(back).subspan(at, std::min<std::size_t>(11, back.size() - at)));
  return back;
}

TEST(ByteLog, GivesBackWhatItWasGivenWhereverItLies) {
  for (const std::size_t in_memory : {0U, 3U, 500U, 999U, 1000U, 5000U})
    EXPECT_EQ(through_log(in_memory), numbered(1000)) << in_memory;
}

TEST(ByteLog, LeavesNoFileBehind) {
  const auto folder = std::filesystem::temp_directory_path() / "wuerfel-byte-log-test";
  std::filesystem::create_directories(folder);
  const char* before = std::getenv("TMPDIR");
  setenv("TMPDIR", folder.c_str(), 1);
  ByteLog log(0);
  log.append(numbered(100));
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  std::filesystem::remove_all(folder);
  EXPECT_THROW(ByteLog(0).append(numbered(1)), OutputError);
  before == nullptr ? unsetenv("TMPDIR") : setenv("TMPDIR", before, 1);
}

}  // namespace
}  // namespace wuerfel
