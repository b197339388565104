#include "app/cli/places.h"

#include <system_error>

#include <fmt/core.h>

#include "app/cli/exit_code.h"

namespace wuerfel {

std::optional<std::filesystem::path> place_of(const std::string& name) {
  if (name == "-") return name;
  std::error_code error;
  if (std::filesystem::is_other(std::filesystem::status(name, error))) return std::nullopt;
  const auto place =
      std::filesystem::weakly_canonical(std::filesystem::absolute(name, error), error);
  return place.has_filename() ? place : place.parent_path();
}

void require_kept(const std::string& read, const std::string& output) {
  std::error_code error;
  // A shipped scene is no file, and standard input is not standard output.
  if (output.empty() || read == "-" || !std::filesystem::exists(read, error)) return;
  const auto place = place_of(output);
  if (place && place == place_of(read)) {
    throw UsageError(
        fmt::format("{} is read and would be replaced; give the output another name", output));
  }
}

}  // namespace wuerfel
