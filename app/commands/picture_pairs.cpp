#include "app/commands/picture_pairs.h"

#include <filesystem>
#include <set>
#include <system_error>

#include <fmt/core.h>

#include "app/cli/exit_code.h"
#include "app/cli/is_folder.h"

namespace wuerfel {

namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

// Paths inside `folder`, in alphabetical order.
void add_names(const std::string& folder, std::set<std::string>& names) {
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    const fs::path& path = entry->path();
    if (path.extension() != ".png" || path.filename().string().starts_with('.')) continue;
    if (entry->is_regular_file()) names.insert(path.lexically_relative(folder).string());
  }
  if (error) throw UsageError(fmt::format("cannot read {}: {}", folder, error.message()));
}

}  // namespace

std::vector<PicturePair> picture_pairs(const std::string& expected,
                                       const std::string& actual,
                                       bool may_be_new) {
  const bool expected_there = is_there(expected);
  if (!is_there(actual)) throw UsageError(fmt::format("there is no {}", actual));
  if (!expected_there && !may_be_new) {
    throw UsageError(fmt::format("there is no {}; --update makes it", expected));
  }
  if (!is_folder(actual) && (!expected_there || !is_folder(expected))) {
    return {{fs::path(actual).filename().string(), expected, actual, expected_there, true}};
  }
  if (expected_there && is_folder(expected) != is_folder(actual)) {
    throw UsageError(
        fmt::format("{} and {} are a file and a folder: give two of a kind", expected, actual));
  }
  std::set<std::string> names;
  if (expected_there) add_names(expected, names);
  add_names(actual, names);
  if (names.empty())
    throw UsageError(fmt::format("there are no .png files in {} and {}", expected, actual));
  std::vector<PicturePair> pairs;
  for (const std::string& name : names) {
    const fs::path here = fs::path(expected) / name;
    const fs::path there = fs::path(actual) / name;
    pairs.push_back({name, here.string(), there.string(), is_there(here), is_there(there)});
  }
  return pairs;
}

}  // namespace wuerfel
