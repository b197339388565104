/// SHA-256: names cases, and proves that bytes are those that were written. CRC-32: notices damage.
#pragma once

#include <cstdint>
#include <sha2.h>
#include <span>
#include <string>
#include <string_view>

namespace wuerfel {

class Sha256 {
 public:
  Sha256();
  Sha256& add(std::span<const std::uint8_t> bytes);
  Sha256& add(std::string_view text);
  /// 64 hexadecimal digits of all that was added.
  [[nodiscard]] std::string hex() const;

 private:
  SHA2_CTX context_;
};

std::string sha256(std::string_view text);
/// Of a file. Throws UsageError where it cannot be read.
std::string sha256_of_file(const std::string& path);
/// As in PNG and zip files [PNG D].
std::uint32_t crc32_of(std::string_view bytes);

}  // namespace wuerfel
