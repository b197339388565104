#include "render/deflate.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <span>

#include "render/huffman.h"

namespace wuerfel {
namespace {

constexpr std::size_t shortest_match = 3;
constexpr std::size_t longest_match = 258;
constexpr std::size_t tokens_per_block = 1U << 16U;
constexpr unsigned end_of_block = 256;

/// The symbol, and the extra bits, of a match length (RFC 1951, section 3.2.5).
struct LengthSymbol {
  std::uint16_t symbol = 0;
  std::uint8_t extra_bits = 0;
  std::uint8_t extra = 0;
};

constexpr std::array<LengthSymbol, longest_match + 1> make_length_symbols() {
  std::array<LengthSymbol, longest_match + 1> table{};
  unsigned symbol = 257;
  std::size_t length = shortest_match;
  for (unsigned group = 0; length < longest_match; ++group) {
    const unsigned extra_bits = group < 2 ? 0 : group - 1;
    const unsigned symbols_in_group = 4;
    for (unsigned i = 0; i < symbols_in_group; ++i, ++symbol) {
      for (unsigned extra = 0; extra < (1U << extra_bits) && length < longest_match;
           ++extra, ++length) {
        table[length] = {static_cast<std::uint16_t>(symbol), static_cast<std::uint8_t>(extra_bits),
                         static_cast<std::uint8_t>(extra)};
      }
    }
  }
  table[longest_match] = {285, 0, 0};
  return table;
}
constexpr std::array<LengthSymbol, longest_match + 1> length_symbols = make_length_symbols();

/// The symbol and the extra bits of a distance.
struct DistanceSymbol {
  unsigned symbol = 0;
  unsigned extra_bits = 0;
  unsigned extra = 0;
};

DistanceSymbol distance_symbol(std::size_t distance) {
  const auto offset = static_cast<unsigned>(distance - 1);
  if (offset < 4) return {offset, 0, 0};
  const unsigned extra_bits = static_cast<unsigned>(std::bit_width(offset)) - 2;
  return {2 * extra_bits + (offset >> extra_bits), extra_bits, offset & ((1U << extra_bits) - 1)};
}

/// Bits from the lowest place on, as deflate packs them.
class BitWriter {
 public:
  explicit BitWriter(std::vector<std::uint8_t>& bytes) : bytes_(bytes), end_(bytes.size()) {}

  /// Room for the bits that follow; without it `put` writes beyond the end.
  void reserve_bits(std::size_t bits) { bytes_.resize(end_ + bits / 8 + sizeof waiting_ + 1); }
  /// At most 32 bits at once.
  void put(std::uint64_t bits, unsigned count) {
    waiting_ |= bits << filled_;
    filled_ += count;
    if (filled_ < 32) return;
    const std::uint64_t whole = waiting_;
    std::uint8_t* target = bytes_.data() + end_;
    for (unsigned i = 0; i < 4; ++i)
      target[i] = static_cast<std::uint8_t>(whole >> (8 * i));
    end_ += 4;
    waiting_ >>= 32U;
    filled_ -= 32;
  }
  /// Fills the last byte and gives back the room that was not needed.
  void finish() {
    bytes_.resize(end_);
    for (; filled_ > 0; filled_ = filled_ > 8 ? filled_ - 8 : 0, waiting_ >>= 8U) {
      bytes_.push_back(static_cast<std::uint8_t>(waiting_));
    }
  }

 private:
  std::vector<std::uint8_t>& bytes_;
  std::size_t end_;
  std::uint64_t waiting_ = 0;
  unsigned filled_ = 0;
};

/// The check sum at the end of a zlib stream (RFC 1950): s1 = 1 + sum of bytes, s2 = sum of all s1,
/// modulo 65521.
class Adler {
 public:
  /// What a row adds, which is the same for an equal row wherever it stands.
  struct Row {
    std::uint32_t sum = 0;       ///< of the bytes
    std::uint32_t weighted = 0;  ///< of the bytes times how many follow, itself included
  };
  static Row sums(std::span<const std::uint8_t> row) {
    constexpr std::size_t block = 2048;  // 255 * 2048 * 2049 / 2 fits into 32 bits
    std::uint64_t sum = 0;
    std::uint64_t weighted = 0;
    for (std::size_t start = 0; start < row.size(); start += block) {
      const std::size_t count = std::min(block, row.size() - start);
      const std::uint8_t* bytes = row.data() + start;
      std::uint32_t block_sum = 0;
      std::uint32_t block_weighted = 0;
      for (std::size_t i = 0; i < count; ++i) {
        block_sum += bytes[i];
        block_weighted += static_cast<std::uint32_t>(count - i) * bytes[i];
      }
      weighted +=
          block_weighted + static_cast<std::uint64_t>(row.size() - start - count) * block_sum;
      sum += block_sum;
    }
    return {static_cast<std::uint32_t>(sum % base), static_cast<std::uint32_t>(weighted % base)};
  }
  void add(const Row& row, std::size_t length) {
    s2_ = (s2_ + length % base * s1_ + row.weighted) % base;
    s1_ = (s1_ + row.sum) % base;
  }
  std::uint32_t value() const { return static_cast<std::uint32_t>((s2_ << 16U) | s1_); }

 private:
  static constexpr std::uint64_t base = 65521;
  std::uint64_t s1_ = 1;
  std::uint64_t s2_ = 0;
};

/// Literals and matches of one block. There are but two distances: one pixel and one row.
class BlockWriter {
 public:
  BlockWriter(std::size_t pixel, std::size_t row, std::vector<std::uint8_t>& bytes)
      : pixel_(distance_symbol(pixel)), row_(distance_symbol(row)), bits_(bytes) {
    tokens_.reserve(tokens_per_block + 1);
  }
  void literal(std::uint8_t byte) {
    tokens_.push_back(byte);
    if (tokens_.size() >= tokens_per_block) flush(false);
  }
  void match(std::size_t length, bool above) {
    tokens_.push_back(static_cast<std::uint16_t>(length + (above ? above_offset : left_offset)));
    if (tokens_.size() >= tokens_per_block) flush(false);
  }
  void finish() {
    flush(true);
    bits_.finish();
  }

 private:
  static constexpr std::uint16_t left_offset = 256;
  static constexpr std::uint16_t above_offset = 1024;

  void flush(bool last);
  void write_codes(const HuffmanCode& letters, const HuffmanCode& distances);

  DistanceSymbol pixel_;
  DistanceSymbol row_;
  BitWriter bits_;
  std::vector<std::uint16_t> tokens_;
};

/// The code lengths themselves, Huffman coded, without run lengths: they are a hundred bytes in a
/// block of many thousands.
void BlockWriter::write_codes(const HuffmanCode& letters, const HuffmanCode& distances) {
  constexpr std::array<std::uint8_t, 19> order{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                               11, 4,  12, 3, 13, 2, 14, 1, 15};
  std::vector<std::uint8_t> lengths = letters.lengths;
  lengths.insert(lengths.end(), distances.lengths.begin(), distances.lengths.end());
  std::array<std::uint32_t, 19> frequencies{};
  for (const std::uint8_t length : lengths)
    ++frequencies.at(length);
  const HuffmanCode code = huffman_code(frequencies, 7);
  bits_.put(letters.lengths.size() - 257, 5);
  bits_.put(distances.lengths.size() - 1, 5);
  bits_.put(order.size() - 4, 4);
  for (const std::uint8_t symbol : order)
    bits_.put(code.lengths[symbol], 3);
  for (const std::uint8_t length : lengths)
    bits_.put(code.bits[length], code.lengths[length]);
}

void BlockWriter::flush(bool last) {
  std::array<std::uint32_t, 286> letter_counts{};
  std::array<std::uint32_t, 30> distance_counts{};
  letter_counts[end_of_block] = 1;
  for (const std::uint16_t token : tokens_) {
    if (token < left_offset) {
      ++letter_counts[token];
      continue;
    }
    const bool above = token >= above_offset;
    ++letter_counts[length_symbols[token - (above ? above_offset : left_offset)].symbol];
    ++distance_counts[above ? row_.symbol : pixel_.symbol];
  }
  const HuffmanCode letters = huffman_code(letter_counts, 15);
  const HuffmanCode distances = huffman_code(distance_counts, 15);
  // A match takes at most 48 bits, a literal 15; the codes' lengths are a few thousand.
  bits_.reserve_bits(48 * tokens_.size() + 8192);
  bits_.put(last ? 1 : 0, 1);
  bits_.put(2, 2);
  write_codes(letters, distances);
  for (const std::uint16_t token : tokens_) {
    if (token < left_offset) {
      bits_.put(letters.bits[token], letters.lengths[token]);
      continue;
    }
    const bool above = token >= above_offset;
    const LengthSymbol& length = length_symbols[token - (above ? above_offset : left_offset)];
    const DistanceSymbol& distance = above ? row_ : pixel_;
    bits_.put(letters.bits[length.symbol], letters.lengths[length.symbol]);
    bits_.put(length.extra, length.extra_bits);
    bits_.put(distances.bits[distance.symbol], distances.lengths[distance.symbol]);
    bits_.put(distance.extra, distance.extra_bits);
  }
  bits_.put(letters.bits[end_of_block], letters.lengths[end_of_block]);
  tokens_.clear();
}

/// How many bytes at `a` and `b` agree, at most `limit`.
std::size_t common_length(const std::uint8_t* a, const std::uint8_t* b, std::size_t limit) {
  std::size_t length = 0;
  while (length + 8 <= limit) {
    std::uint64_t first = 0;
    std::uint64_t second = 0;
    std::memcpy(&first, a + length, 8);
    std::memcpy(&second, b + length, 8);
    if (first != second) {
      return length + static_cast<std::size_t>(std::countr_zero(first ^ second)) / 8;
    }
    length += 8;
  }
  while (length < limit && a[length] == b[length])
    ++length;
  return length;
}

/// Matches for `length` bytes that equal those one row above.
void repeat_above(std::size_t length, BlockWriter& block) {
  while (length >= shortest_match) {
    std::size_t part = std::min(length, longest_match);
    // No rest may be left that is too short to be a match.
    if (length - part > 0 && length - part < shortest_match) part -= shortest_match;
    block.match(part, true);
    length -= part;
  }
}

/// One row as literals and matches; `above` is empty for the first. A run to the left is preferred,
/// since its short distance costs fewer bits.
void encode_row(std::span<const std::uint8_t> row,
                std::span<const std::uint8_t> above,
                std::size_t pixel,
                BlockWriter& block) {
  for (std::size_t i = 0; i < row.size();) {
    const std::size_t left = row.size() - i;
    const std::size_t limit = std::min(left, longest_match);
    const std::uint8_t* at = row.data() + i;
    const std::size_t run = i >= pixel ? common_length(at, at - pixel, limit) : 0;
    const std::size_t up =
        run == limit || above.empty() ? 0 : common_length(at, above.data() + i, left);
    if (up >= longest_match) {
      repeat_above(up, block);
      i += up;
    } else if (const std::size_t length = std::max(run, up); length >= shortest_match) {
      block.match(length, up > run);
      i += length;
    } else {
      block.literal(row[i++]);
    }
  }
}

void convert_row(const std::uint8_t* rgba,
                 int width,
                 int channels,
                 std::vector<std::uint8_t>& row) {
  std::uint8_t* target = row.data() + 1;
  if (channels == 4) {
    std::copy_n(rgba, 4 * static_cast<std::ptrdiff_t>(width), target);
    return;
  }
  // Four bytes at a time; the fourth is overwritten by the next pixel. The row has a byte to spare
  // for the last one.
  for (int x = 0; x < width; ++x, rgba += 4, target += 3)
    std::memcpy(target, rgba, 4);
}

}  // namespace

std::vector<std::uint8_t> deflate_image(const Image& image, int channels) {
  const std::size_t pixel_bytes = 4 * static_cast<std::size_t>(image.width());
  const std::size_t size =
      1 + static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(channels);
  std::vector<std::uint8_t> bytes{0x78, 0x01};
  bytes.reserve(size * static_cast<std::size_t>(image.height()) / 16 + 1024);
  // Rows farther apart than deflate's window cannot be referred to.
  constexpr std::size_t window = 32768;
  const bool reach_above = size <= window;
  BlockWriter block(static_cast<std::size_t>(channels), reach_above ? size : 1, bytes);
  Adler adler;
  Adler::Row sums;
  std::vector<std::uint8_t> row(size + 1, 0);
  std::vector<std::uint8_t> above(size + 1, 0);
  for (int y = 0; y < image.height(); ++y) {
    const bool repeated = y > 0 && std::memcmp(image.row(y), image.row(y - 1), pixel_bytes) == 0;
    if (!repeated) {
      std::swap(row, above);
      convert_row(image.row(y), image.width(), channels, row);
      sums = Adler::sums({row.data(), size});
    }
    adler.add(sums, size);
    if (repeated && reach_above) {
      repeat_above(size, block);
    } else {
      encode_row({row.data(), size}, {above.data(), y > 0 && reach_above ? size : 0},
                 static_cast<std::size_t>(channels), block);
    }
  }
  block.finish();
  for (const unsigned shift : {24U, 16U, 8U, 0U}) {
    bytes.push_back(static_cast<std::uint8_t>(adler.value() >> shift));
  }
  return bytes;
}

}  // namespace wuerfel
