#include "render/files/png_chunks.h"

#include <cstddef>
#include <zlib.h>

namespace wuerfel::internal {
namespace {

constexpr std::size_t frame_bytes = 12;  ///< length, type, check sum

std::uint32_t u32_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  return (std::uint32_t{bytes[at]} << 24U) | (std::uint32_t{bytes[at + 1]} << 16U)
         | (std::uint32_t{bytes[at + 2]} << 8U) | std::uint32_t{bytes[at + 3]};
}

}  // namespace

std::vector<PngChunk> png_chunks(std::span<const std::uint8_t> file) {
  std::vector<PngChunk> chunks;
  for (std::size_t at = png_signature.size(); at + frame_bytes <= file.size();) {
    const std::size_t length = u32_at(file, at);
    if (length > file.size() - at - frame_bytes) break;
    const auto* const type = reinterpret_cast<const char*>(file.data() + at + 4);
    chunks.push_back({std::string_view(type, 4), file.subspan(at + 8, length)});
    at += frame_bytes + length;
  }
  return chunks;
}

void append_u32(std::uint32_t value, std::vector<std::uint8_t>& bytes) {
  append_u16(value >> 16U, bytes);
  append_u16(value & 0xFFFFU, bytes);
}

void append_u16(std::uint32_t value, std::vector<std::uint8_t>& bytes) {
  bytes.push_back(static_cast<std::uint8_t>(value >> 8U));
  bytes.push_back(static_cast<std::uint8_t>(value & 0xFFU));
}

std::uint32_t chunk_check_sum(std::string_view type, std::span<const std::uint8_t> data) {
  const uLong sum =
      crc32(0, reinterpret_cast<const Bytef*>(type.data()), static_cast<uInt>(type.size()));
  // Where there are no bytes, their address may be null, which zlib takes for a new beginning.
  if (data.empty()) return static_cast<std::uint32_t>(sum);
  return static_cast<std::uint32_t>(crc32_z(sum, data.data(), data.size()));
}

void append_chunk(std::string_view type,
                  std::span<const std::uint8_t> data,
                  std::vector<std::uint8_t>& file) {
  append_chunk(type, data, chunk_check_sum(type, data), file);
}

void append_chunk(std::string_view type,
                  std::span<const std::uint8_t> data,
                  std::uint32_t check_sum,
                  std::vector<std::uint8_t>& file) {
  append_u32(static_cast<std::uint32_t>(data.size()), file);
  file.insert(file.end(), type.begin(), type.end());
  file.insert(file.end(), data.begin(), data.end());
  append_u32(check_sum, file);
}

}  // namespace wuerfel::internal
