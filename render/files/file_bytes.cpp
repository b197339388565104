#include "render/files/file_bytes.h"

#include <sstream>

namespace wuerfel {

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
