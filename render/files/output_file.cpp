#include "render/files/output_file.h"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>

#include "render/error.h"

namespace wuerfel {
namespace {

/// folder/.name.RANDOM.part.suffix
std::string temporary_name(const std::filesystem::path& path) {
  std::uint64_t random = 0;
  if (getrandom(&random, sizeof random, 0) != sizeof random) random = 0;
  const std::string name =
      fmt::format(".{}.{:016x}.part{}", path.stem().string(), random, path.extension().string());
  return (path.parent_path() / name).string();
}

/// Whether a name is one of those above, of an output whose name begins so.
bool is_temporary(std::string_view name, std::string_view beginning) {
  constexpr std::string_view mark = ".part";
  constexpr int digits = 16;
  const std::size_t at = name.find(mark);
  if (at == std::string_view::npos || at < digits + 1) return false;
  const std::string_view random = name.substr(at - digits, digits);
  return name.starts_with('.') && name.substr(1).starts_with(beginning)
         && name[at - digits - 1] == '.'
         && random.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace

void remove_left_behind(const std::filesystem::path& folder, std::string_view beginning) {
  std::error_code error;
  for (const auto& entry :
       std::filesystem::directory_iterator(folder.empty() ? "." : folder, error)) {
    if (!is_temporary(entry.path().filename().string(), beginning)) continue;
    const int descriptor =
        open(entry.path().c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) continue;
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) unlink(entry.path().c_str());
    close(descriptor);
  }
}

/// A pipe or a device would be gone where a file took its name.
void OutputFile::require_replaceable(const std::filesystem::path& target) const {
  std::error_code ignored;
  const std::filesystem::file_status there = std::filesystem::symlink_status(target, ignored);
  if (std::filesystem::is_directory(there))
    throw OutputError(fmt::format("cannot write {}: it is a folder", path_));
  if (std::filesystem::is_other(there)) {
    throw OutputError(
        fmt::format("cannot write {}: it is a pipe or a device, and this goes into files only; "
                    "choose another name",
                    path_));
  }
}

OutputFile::OutputFile(std::string path, bool one_of_many) : path_(std::move(path)) {
  const std::filesystem::path target(path_);
  require_replaceable(target);
  if (target.has_parent_path()) {
    std::error_code error;
    std::filesystem::create_directories(target.parent_path(), error);
    if (error) {
      throw OutputError("cannot make the folder " + target.parent_path().string() + ": "
                        + error.message());
    }
  }
  if (!one_of_many) remove_left_behind(target.parent_path(), target.stem().string() + ".");
  constexpr int tries = 10;
  for (int i = 0; i < tries && !make(target); ++i) {
    if (errno != EEXIST) break;
  }
  if (descriptor_ < 0) fail("cannot write");
}

/// One try to make the temporary file. Its lock tells others that somebody writes it.
bool OutputFile::make(const std::filesystem::path& target) {
  temporary_ = temporary_name(target);
  descriptor_ = open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor_ < 0) return false;
  // A program that starts just now may have taken it for one that was left behind.
  struct stat status {};
  if (flock(descriptor_, LOCK_EX) == 0 && fstat(descriptor_, &status) == 0
      && status.st_nlink == 0) {
    close(descriptor_);
    descriptor_ = -1;
    errno = EEXIST;
    return false;
  }
  return true;
}

OutputFile::~OutputFile() {
  if (descriptor_ < 0) return;
  close(descriptor_);
  unlink(temporary_.c_str());
}

void OutputFile::fail(const std::string& what) const {
  throw OutputError(what + " " + path_ + ": " + std::generic_category().message(errno));
}

void OutputFile::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot write");
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void OutputFile::patch(std::uint64_t offset, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written =
        pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot write");
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    offset += static_cast<std::uint64_t>(written);
  }
}

void OutputFile::commit() {
  // A full disk may only be noticed when the file is closed.
  const int descriptor = descriptor_;
  const int lock = dup(descriptor);  // until it has its name
  descriptor_ = -1;
  const bool done = close(descriptor) == 0 && rename(temporary_.c_str(), path_.c_str()) == 0;
  const int reason = errno;
  if (!done) unlink(temporary_.c_str());
  close(lock);
  errno = reason;
  if (!done) fail("cannot write");
}

}  // namespace wuerfel
