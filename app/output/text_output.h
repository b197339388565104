/// Text, or a picture, that goes into a file, appearing whole or not at all, or to standard output.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "render/files/output_file.h"

namespace wuerfel {

/// `-` is standard output. Pipes, devices and what lies in /dev are written to directly. A file takes the place of
/// what had its name: a link is not followed.
class TextOutput {
 public:
  /// Throws OutputError where no such file can be made.
  explicit TextOutput(const std::string& path);
  ~TextOutput();
  TextOutput(const TextOutput&) = delete;
  TextOutput& operator=(const TextOutput&) = delete;

  /// Throws OutputError, and Interrupted where nobody reads standard output any more.
  void write(std::string_view text);
  void write(std::span<const std::uint8_t> bytes);
  /// Throws the same. Without this call a file does not appear.
  void finish();

 private:
  void flush();
  [[noreturn]] void fail() const;

  std::string name_;                ///< what messages call it
  std::optional<OutputFile> file_;  ///< none: written to `descriptor_`
  int descriptor_ = -1;
  std::string buffer_;
};

/// Throws OutputError.
void write_text(const std::string& path, std::string_view text);

}  // namespace wuerfel
