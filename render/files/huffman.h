/// Huffman codes as deflate wants them (RFC 1951, section 3.2.2).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace wuerfel {

struct HuffmanCode {
  std::vector<std::uint8_t> lengths;  ///< bits; 0: the symbol does not occur
  std::vector<std::uint16_t>
      bits;  ///< in the order in which they are sent, the first in the lowest place
};

/// An optimal prefix code for these frequencies in which no code is longer than `longest` bits
/// (nearly optimal where that limit matters). A single symbol gets one bit.
HuffmanCode huffman_code(std::span<const std::uint32_t> frequencies, int longest);

}  // namespace wuerfel
