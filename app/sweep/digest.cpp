#include "app/sweep/digest.h"

#include <array>
#include <fstream>
#include <zlib.h>

#include <fmt/format.h>

#include "app/cli/exit_code.h"

namespace wuerfel {

Sha256::Sha256() : context_() { SHA256Init(&context_); }

Sha256& Sha256::add(std::span<const std::uint8_t> bytes) {
  SHA256Update(&context_, bytes.data(), bytes.size());
  return *this;
}

Sha256& Sha256::add(std::string_view text) {
  return add({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

std::string Sha256::hex() const {
  SHA2_CTX context = context_;
  std::array<std::uint8_t, SHA256_DIGEST_LENGTH> digest{};
  SHA256Final(digest.data(), &context);
  return fmt::format("{:02x}", fmt::join(digest, ""));
}

std::string sha256(std::string_view text) { return Sha256().add(text).hex(); }

std::string sha256_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw UsageError(fmt::format("{}: cannot be read", path));
  Sha256 digest;
  std::string block(std::size_t{1} << 20U, '\0');
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0)
    digest.add(std::string_view(block).substr(0, static_cast<std::size_t>(file.gcount())));
  return digest.hex();
}

std::uint32_t crc32_of(std::string_view bytes) {
  const auto* const start = reinterpret_cast<const Bytef*>(bytes.data());
  return static_cast<std::uint32_t>(crc32_z(0, start, bytes.size()));
}

}  // namespace wuerfel
