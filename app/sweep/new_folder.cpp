#include "app/sweep/new_folder.h"

#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

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

}  // namespace

NewFolder::NewFolder(const fs::path& path) : path_(without_slash(path)) {
  std::error_code error;
  if (fs::exists(path_, error) && !(fs::is_directory(path_, error) && fs::is_empty(path_, error))) {
    throw UsageError(
        fmt::format("{} is there already; remove it or take another name", path_.string()));
  }
  if (path_.has_parent_path()) fs::create_directories(path_.parent_path(), error);
  if (error) fail(path_, error);
  std::string name = path_.string() + ".partial-XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) fail(path_, {errno, std::generic_category()});
  temporary_ = name;
  fs::permissions(temporary_,
                  fs::perms::group_read | fs::perms::group_exec | fs::perms::others_read
                      | fs::perms::others_exec,
                  fs::perm_options::add, error);
}

NewFolder::~NewFolder() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
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
