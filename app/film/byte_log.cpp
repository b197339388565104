#include "app/film/byte_log.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <system_error>
#include <unistd.h>

#include <fmt/core.h>

#include "render/error.h"

namespace wuerfel {

namespace {

std::string temporary_folder() {
  const char* named = std::getenv("TMPDIR");  // NOLINT(concurrency-mt-unsafe)
  return named == nullptr || *named == '\0' ? "/tmp" : named;
}

[[noreturn]] void fail() {
  throw OutputError(fmt::format("cannot keep the motion in {}: {}; TMPDIR can name another folder",
                                temporary_folder(), std::generic_category().message(errno)));
}

int open_nameless() {
  std::string name = temporary_folder() + "/wuerfel-XXXXXX";
  const int file = ::mkostemp(name.data(), O_CLOEXEC);
  if (file < 0) fail();
  ::unlink(name.c_str());
  return file;
}

}  // namespace

ByteLog::ByteLog(std::size_t in_memory) : limit_(in_memory) {}

ByteLog::~ByteLog() {
  if (file_ >= 0) ::close(file_);
}

void ByteLog::append(std::span<const std::uint8_t> bytes) {
  const std::size_t room = std::min(bytes.size(), limit_ - memory_.size());
  memory_.insert(memory_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(room));
  bytes = bytes.subspan(room);
  if (!bytes.empty() && file_ < 0) file_ = open_nameless();
  while (!bytes.empty()) {
    const ssize_t count = ::write(file_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail();
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
}

void ByteLog::read(std::uint64_t offset, std::span<std::uint8_t> bytes) const {
  if (offset < memory_.size()) {
    const std::size_t count = std::min<std::size_t>(bytes.size(), memory_.size() - offset);
    std::copy_n(memory_.begin() + static_cast<std::ptrdiff_t>(offset), count, bytes.begin());
    bytes = bytes.subspan(count);
    offset += count;
  }
  while (!bytes.empty()) {
    const ssize_t count =
        ::pread(file_, bytes.data(), bytes.size(), static_cast<off_t>(offset - memory_.size()));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail();
    bytes = bytes.subspan(static_cast<std::size_t>(count));
    offset += static_cast<std::uint64_t>(count);
  }
}

}  // namespace wuerfel
