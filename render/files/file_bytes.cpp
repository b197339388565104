#include "render/files/file_bytes.h"

#include <cerrno>
#include <filesystem>
#include <sstream>
#include <system_error>

#include "render/error.h"

namespace wuerfel {

std::ifstream open_to_read(const std::string& path) {
  std::error_code ignored;
  const bool is_folder = std::filesystem::is_directory(path, ignored);
  std::ifstream file(path, std::ios::binary);
  if (file && !is_folder) return file;
  const std::string reason = is_folder ? "it is a folder" : std::generic_category().message(errno);
  throw RenderError("cannot read " + path + ": " + reason);
}

std::string file_bytes(std::istream& file, std::string_view beginning) {
  std::string bytes(beginning.size(), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  if (bytes != beginning) return bytes;
  std::ostringstream rest;
  rest << file.rdbuf();
  return bytes + rest.str();
}

}  // namespace wuerfel
