/// A folder that appears whole or not at all.
#pragma once

#include <filesystem>
#include <string>

namespace wuerfel {

/// Is filled under a temporary name beside `path`; `commit` gives it its name, and without that the
/// destructor removes it. What a program left there that was killed, the next one of the same path
/// removes: a lock tells whether its owner lives.
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
  int lock_ = -1;  ///< on the folder, while it has its temporary name
};

}  // namespace wuerfel
