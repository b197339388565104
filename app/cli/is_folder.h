/// Whether a path is that of a folder.
#pragma once

#include <filesystem>
#include <system_error>

namespace wuerfel {

/// What cannot be asked about is none.
inline bool is_folder(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored);
}

}  // namespace wuerfel
