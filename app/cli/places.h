/// Names of files, and the places that they mean.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace wuerfel {

/// All names of one file or folder have one place; devices, which take anything from anybody, have none. `-` is
/// its own.
std::optional<std::filesystem::path> place_of(const std::string& name);

/// Throws UsageError where an output would replace the file or folder that is read.
void require_kept(const std::string& read, const std::string& output);

}  // namespace wuerfel
