/// ByteLog: bytes that are written once and read from the start, any number of times, in bounded
/// memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace wuerfel {

class ByteLog {
 public:
  /// The first `in_memory` bytes stay in memory. The rest goes to a file without a name in the
  /// temporary folder, which is gone when the program ends, however it ends.
  explicit ByteLog(std::size_t in_memory = std::size_t{64} << 20U);
  ~ByteLog();
  ByteLog(const ByteLog&) = delete;
  ByteLog& operator=(const ByteLog&) = delete;

  /// Throws OutputError where the temporary folder is full or cannot be written.
  void append(std::span<const std::uint8_t> bytes);

  /// Fills `bytes` with what was written from `offset` on. Throws OutputError where the file cannot
  /// be read.
  void read(std::uint64_t offset, std::span<std::uint8_t> bytes) const;

 private:
  std::size_t limit_;
  std::vector<std::uint8_t> memory_;
  int file_ = -1;
};

}  // namespace wuerfel
