/// Tar archives as readers of WebDataset expect them: the files of one sample stand side by side and
/// share a base name. POSIX ustar; no date, no owner, so that equal files give equal bytes.
#pragma once

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wuerfel {

/// A file in an archive.
struct TapeFile {
  std::string name;  ///< at most 100 bytes
  std::string bytes;
};

/// The blocks of these files: they can stand anywhere in an archive.
std::string tape_blocks(const std::vector<TapeFile>& files);

/// What stands behind the last file of an archive.
std::string tape_end();

/// Reads an archive file by file. Throws UsageError, naming it, where it is damaged.
class TapeReader {
 public:
  explicit TapeReader(std::string path);
  /// None behind the last.
  std::optional<TapeFile> next();

 private:
  [[noreturn]] void fail(const std::string& message) const;

  std::string path_;
  std::ifstream file_;
};

/// The files that blocks of tape_blocks() hold. Throws UsageError where they are damaged.
std::vector<TapeFile> files_in(std::string_view blocks);

}  // namespace wuerfel
