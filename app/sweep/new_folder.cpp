#include "app/sweep/new_folder.h"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <string_view>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/cli/exit_code.h"
#include "render/error.h"

namespace wuerfel {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, const std::error_code& error) {
  throw OutputError(fmt::format("cannot write {}: {}", path.string(), error.message()));
}

// "a/" is "a".
fs::path without_slash(const fs::path& path) {
  return path.has_filename() ? path : path.parent_path();
}

constexpr std::string_view temporary_mark = ".partial-";

/// A descriptor of a folder that nobody else has locked; -1 where somebody has, or no lock is to be had.
int locked(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0 || ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  ::close(descriptor);
  return -1;
}

/// Folders of this path that lost their owner.
void remove_orphans(const fs::path& path) {
  const std::string start = path.filename().string() + std::string(temporary_mark);
  std::error_code ignored;
  std::vector<fs::path> found;
  const fs::path beside = path.has_parent_path() ? path.parent_path() : ".";
  for (const auto& entry : fs::directory_iterator(beside, ignored)) {
    if (entry.path().filename().string().starts_with(start) && entry.is_directory(ignored))
      found.push_back(entry.path());
  }
  for (const fs::path& folder : found) {
    const int lock = locked(folder);
    if (lock < 0) continue;
    fs::remove_all(folder, ignored);
    ::close(lock);
  }
}

}  // namespace

NewFolder::NewFolder(const fs::path& path) : path_(without_slash(path)) {
  std::error_code error;
  if (fs::exists(path_, error) && !(fs::is_directory(path_, error) && fs::is_empty(path_, error))) {
    throw UsageError(
        fmt::format("{} is there already; remove it or take another name", path_.string()));
  }
  if (path_.has_parent_path()) fs::create_directories(path_.parent_path(), error);
  if (error) fail(path_, error);
  remove_orphans(path_);
  std::string name = path_.string() + std::string(temporary_mark) + "XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) fail(path_, {errno, std::generic_category()});
  temporary_ = name;
  lock_ = locked(temporary_);
  fs::permissions(temporary_,
                  fs::perms::group_read | fs::perms::group_exec | fs::perms::others_read
                      | fs::perms::others_exec,
                  fs::perm_options::add, error);
}

NewFolder::~NewFolder() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

std::string NewFolder::file(const std::string& name) const { return (temporary_ / name).string(); }

void NewFolder::commit() {
  std::error_code error;
  fs::remove(path_, error);  // an empty folder
  fs::rename(temporary_, path_, error);
  if (error) fail(path_, error);
  temporary_.clear();
}

}  // namespace wuerfel
