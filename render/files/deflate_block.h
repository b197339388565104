/// DeflateBlocks: literals and matches in, Huffman coded blocks out (RFC 1951, section 3.2).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/raster/image.h"

namespace wuerfel {

struct HuffmanCode;

/// Some pixels as they are, and then copies of pixels at one of two distances. A row has at most
/// 16384 pixels.
struct DeflateStep {
  std::uint32_t first = 0;    ///< pixel of the image, counted row by row
  std::uint16_t literal = 0;  ///< pixels from there on that are sent as they are
  std::uint16_t match = 0;    ///< pixels that are copied
  bool above = false;         ///< from one row above; else from one pixel to the left
  bool row_begin = false;     ///< PNG's filter byte, a zero, comes first
};

/// Collects steps and writes a block, with codes of its own, whenever many have come together.
class DeflateBlocks {
 public:
  /// `channels` bytes of every pixel are sent; a row takes `row` bytes. Writes behind what stands
  /// in `bytes`.
  DeflateBlocks(const Image& image,
                std::size_t channels,
                std::size_t row,
                std::vector<std::uint8_t>& bytes);

  void add(const DeflateStep& step);
  /// Bits that these steps take, roughly.
  [[nodiscard]] std::size_t estimate(std::span<const DeflateStep> steps) const;
  /// The last block.
  void finish();

 private:
  /// The symbol, and the extra bits, of a distance.
  struct Distance {
    unsigned symbol = 0;
    unsigned extra_bits = 0;
    unsigned extra = 0;
  };
  static Distance distance_of(std::size_t bytes);

  void put(std::uint64_t bits, unsigned count);
  void flush(bool last);
  void write_codes(const HuffmanCode& letters, const HuffmanCode& distances);
  void count_letters(std::span<std::uint32_t> letters, std::span<std::uint32_t> distances) const;
  void write_step(const DeflateStep& step,
                  const HuffmanCode& letters,
                  std::span<const std::uint64_t> left_matches,
                  std::span<const std::uint64_t> above_matches);
  /// How many pixels one match can be; any rest is long enough to be one, too.
  [[nodiscard]] std::size_t longest_part() const { return 258 / channels_; }

  const std::uint8_t* pixels_;
  std::size_t channels_;
  Distance left_;
  Distance above_;
  std::vector<DeflateStep> steps_;
  std::size_t tokens_ = 0;  ///< literals and matches in `steps_`
  std::vector<std::uint8_t>& bytes_;
  std::size_t end_;  ///< of what is written of `bytes_`
  std::uint64_t waiting_ = 0;
  unsigned filled_ = 0;  ///< bits in `waiting_`
};

}  // namespace wuerfel
