/// PNG's outer form: a signature and chunks of length, type, data and check sum (PNG specification,
/// section 5).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace wuerfel::internal {

constexpr std::array<std::uint8_t, 8> png_signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

struct PngChunk {
  std::string_view type;  ///< four letters, in the bytes of the file
  std::span<const std::uint8_t> data;
};

/// The chunks of a file that this program wrote.
std::vector<PngChunk> png_chunks(std::span<const std::uint8_t> file);

/// Appends one chunk.
void append_chunk(std::string_view type,
                  std::span<const std::uint8_t> data,
                  std::vector<std::uint8_t>& file);

/// The same where the check sum is known already.
void append_chunk(std::string_view type,
                  std::span<const std::uint8_t> data,
                  std::uint32_t check_sum,
                  std::vector<std::uint8_t>& file);
/// CRC-32 of type and data.
std::uint32_t chunk_check_sum(std::string_view type, std::span<const std::uint8_t> data);

/// Appends big-endian numbers, PNG's only kind.
void append_u32(std::uint32_t value, std::vector<std::uint8_t>& bytes);
void append_u16(std::uint32_t value, std::vector<std::uint8_t>& bytes);

}  // namespace wuerfel::internal
