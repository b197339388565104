/// A folder that appears whole or not at all.
#pragma once

#include <filesystem>
#include <string>

namespace wuerfel {

/// Is filled under a temporary name beside `path`; `commit` gives it its name, and without that the
/// destructor removes it.
class NewFolder {
 public:
  /// Throws UsageError where something of that name is there, and OutputError where it cannot be
  /// made.
  explicit NewFolder(const std::filesystem::path& path);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  /// The name of a file in it, now.
  [[nodiscard]] std::string file(const std::string& name) const;
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;
};

}  // namespace wuerfel
