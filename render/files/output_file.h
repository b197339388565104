/// OutputFile: a file that appears whole or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace wuerfel {

/// Removes what programs that were killed have left in a folder: temporary files of outputs whose names
/// begin so and that no living program writes.
void remove_left_behind(const std::filesystem::path& folder, std::string_view beginning);

/// Writes under a temporary name beside `path`; `commit` gives it its name, and without that the
/// destructor removes it. The temporary name keeps the suffix, by which other programs tell the
/// format, and is one that nobody can foresee: a link that waits there is not followed. Missing
/// folders are made.
class OutputFile {
 public:
  /// Throws OutputError where the folder cannot be made or written, or `path` is a folder, a pipe or a
  /// device, which a file must not replace. What killed programs have left of a
  /// file of this name is removed; of one of many (frames) that is left to who knows them all.
  explicit OutputFile(std::string path, bool one_of_many = false);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  OutputFile(OutputFile&&) = delete;
  OutputFile& operator=(OutputFile&&) = delete;

  void write(std::span<const std::uint8_t> bytes);
  /// Overwrites bytes that were written before, from `offset` on.
  void patch(std::uint64_t offset, std::span<const std::uint8_t> bytes);
  void commit();

  const std::string& path() const { return path_; }
  /// For another program to write into.
  const std::string& temporary_path() const { return temporary_; }

 private:
  [[noreturn]] void fail(const std::string& what) const;
  void require_replaceable(const std::filesystem::path& target) const;
  bool make(const std::filesystem::path& target);
  std::string path_;
  std::string temporary_;
  int descriptor_ = -1;
};

}  // namespace wuerfel
