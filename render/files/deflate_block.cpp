#include "render/files/deflate_block.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "render/files/huffman.h"

namespace wuerfel {
namespace {

constexpr std::size_t shortest_match = 3;
constexpr std::size_t longest_match = 258;
constexpr std::size_t tokens_per_block = 1U << 15U;
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

/// A whole match in one word: how many bits it takes in the lowest six, the bits above. A match
/// takes at most 48 bits.
constexpr unsigned bit_count_width = 6;

std::uint64_t packed_match(std::size_t length,
                           unsigned distance_symbol,
                           unsigned distance_extra_bits,
                           unsigned distance_extra,
                           const HuffmanCode& letters,
                           const HuffmanCode& distances) {
  const LengthSymbol& symbol = length_symbols.at(length);
  std::uint64_t bits = 0;
  unsigned count = 0;
  const auto append = [&](std::uint64_t value, unsigned width) {
    bits |= value << count;
    count += width;
  };
  append(letters.bits[symbol.symbol], letters.lengths[symbol.symbol]);
  append(symbol.extra, symbol.extra_bits);
  append(distances.bits[distance_symbol], distances.lengths[distance_symbol]);
  append(distance_extra, distance_extra_bits);
  return (bits << bit_count_width) | count;
}

}  // namespace

DeflateBlocks::Distance DeflateBlocks::distance_of(std::size_t bytes) {
  const auto offset = static_cast<unsigned>(bytes - 1);
  if (offset < 4) return {offset, 0, 0};
  const unsigned extra_bits = static_cast<unsigned>(std::bit_width(offset)) - 2;
  return {2 * extra_bits + (offset >> extra_bits), extra_bits, offset & ((1U << extra_bits) - 1)};
}

DeflateBlocks::DeflateBlocks(const Image& image,
                             std::size_t channels,
                             std::size_t row,
                             std::vector<std::uint8_t>& bytes)
    : pixels_(image.bytes().data()),
      channels_(channels),
      left_(distance_of(channels)),
      above_(distance_of(row)),
      bytes_(bytes),
      end_(bytes.size()) {}

void DeflateBlocks::add(const DeflateStep& step) {
  steps_.push_back(step);
  tokens_ += step.literal * channels_ + step.match / longest_part() + 2;
  if (tokens_ >= tokens_per_block) flush(false);
}

std::size_t DeflateBlocks::estimate(std::span<const DeflateStep> steps) const {
  constexpr std::size_t literal_bits = 7;
  constexpr std::size_t left_bits = 4;
  std::size_t bits = 0;
  for (const DeflateStep& step : steps) {
    const std::size_t parts = (step.match + longest_part() - 1) / longest_part();
    bits += literal_bits * channels_ * step.literal
            + parts * (left_bits + (step.above ? above_.extra_bits : 0));
  }
  return bits;
}

/// At most 48 bits at once. The room for them was made by `flush`.
void DeflateBlocks::put(std::uint64_t bits, unsigned count) {
  waiting_ |= bits << filled_;
  filled_ += count;
  const std::uint64_t whole = waiting_;
  std::uint8_t* target = bytes_.data() + end_;
  for (unsigned i = 0; i < 8; ++i)
    target[i] = static_cast<std::uint8_t>(whole >> (8 * i));
  const unsigned done = filled_ / 8;
  end_ += done;
  waiting_ = done == 8 ? 0 : waiting_ >> (8 * done);
  filled_ %= 8;
}

/// The code lengths themselves, Huffman coded, without run lengths: they are a hundred bytes in a
/// block of many thousands.
void DeflateBlocks::write_codes(const HuffmanCode& letters, const HuffmanCode& distances) {
  constexpr std::array<std::uint8_t, 19> order{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                               11, 4,  12, 3, 13, 2, 14, 1, 15};
  std::vector<std::uint8_t> lengths = letters.lengths;
  lengths.insert(lengths.end(), distances.lengths.begin(), distances.lengths.end());
  std::array<std::uint32_t, 19> frequencies{};
  for (const std::uint8_t length : lengths)
    ++frequencies.at(length);
  const HuffmanCode code = huffman_code(frequencies, 7);
  put(letters.lengths.size() - 257, 5);
  put(distances.lengths.size() - 1, 5);
  put(order.size() - 4, 4);
  for (const std::uint8_t symbol : order)
    put(code.lengths[symbol], 3);
  for (const std::uint8_t length : lengths)
    put(code.bits[length], code.lengths[length]);
}

void DeflateBlocks::count_letters(std::span<std::uint32_t> letters,
                                  std::span<std::uint32_t> distances) const {
  const std::size_t part = longest_part();
  for (const DeflateStep& step : steps_) {
    letters[0] += step.row_begin ? 1 : 0;
    const std::uint8_t* pixel = pixels_ + 4 * step.first;
    for (std::uint32_t i = 0; i < step.literal; ++i, pixel += 4) {
      ++letters[pixel[0]];
      ++letters[pixel[1]];
      ++letters[pixel[2]];
      if (channels_ == 4) ++letters[pixel[3]];
    }
    if (step.match == 0) continue;
    const auto whole = static_cast<std::uint32_t>(step.match / part);
    const std::size_t rest = step.match % part;
    letters[length_symbols.at(part * channels_).symbol] += whole;
    if (rest > 0) ++letters[length_symbols.at(rest * channels_).symbol];
    distances[step.above ? above_.symbol : left_.symbol] += whole + (rest > 0 ? 1 : 0);
  }
}

void DeflateBlocks::write_step(const DeflateStep& step,
                               const HuffmanCode& letters,
                               std::span<const std::uint64_t> left_matches,
                               std::span<const std::uint64_t> above_matches) {
  if (step.row_begin) put(letters.bits[0], letters.lengths[0]);
  const std::uint8_t* pixel = pixels_ + 4 * step.first;
  for (std::uint32_t i = 0; i < step.literal; ++i, pixel += 4) {
    // Three codes of at most 15 bits at once.
    const unsigned first = letters.lengths[pixel[0]];
    const unsigned second = first + letters.lengths[pixel[1]];
    put(letters.bits[pixel[0]] | static_cast<std::uint64_t>(letters.bits[pixel[1]]) << first
            | static_cast<std::uint64_t>(letters.bits[pixel[2]]) << second,
        second + letters.lengths[pixel[2]]);
    if (channels_ == 4) put(letters.bits[pixel[3]], letters.lengths[pixel[3]]);
  }
  const std::span<const std::uint64_t> matches = step.above ? above_matches : left_matches;
  const std::size_t part = longest_part();
  const auto write_match = [&](std::size_t pixels) {
    constexpr std::uint64_t count_mask = (1U << bit_count_width) - 1;
    const std::uint64_t packed = matches[pixels * channels_];
    put(packed >> bit_count_width, static_cast<unsigned>(packed & count_mask));
  };
  std::size_t left = step.match;
  for (; left >= part; left -= part)
    write_match(part);
  if (left > 0) write_match(left);
}

void DeflateBlocks::flush(bool last) {
  std::array<std::uint32_t, 286> letter_counts{};
  std::array<std::uint32_t, 30> distance_counts{};
  letter_counts[end_of_block] = 1;
  count_letters(letter_counts, distance_counts);
  const HuffmanCode letters = huffman_code(letter_counts, 15);
  const HuffmanCode distances = huffman_code(distance_counts, 15);
  // A match takes at most 48 bits, a literal 15; the codes' lengths are a few thousand.
  constexpr std::size_t bytes_per_token = 6;
  bytes_.resize(end_ + bytes_per_token * tokens_ + 2048);
  put(last ? 1 : 0, 1);
  put(2, 2);
  write_codes(letters, distances);
  std::array<std::uint64_t, longest_match + 1> left_matches{};
  std::array<std::uint64_t, longest_match + 1> above_matches{};
  for (std::size_t length = shortest_match; length <= longest_match; ++length) {
    left_matches.at(length) =
        packed_match(length, left_.symbol, left_.extra_bits, left_.extra, letters, distances);
    above_matches.at(length) =
        packed_match(length, above_.symbol, above_.extra_bits, above_.extra, letters, distances);
  }
  for (const DeflateStep& step : steps_)
    write_step(step, letters, left_matches, above_matches);
  put(letters.bits[end_of_block], letters.lengths[end_of_block]);
  steps_.clear();
  tokens_ = 0;
}

void DeflateBlocks::finish() {
  flush(true);
  if (filled_ > 0) bytes_.at(end_++) = static_cast<std::uint8_t>(waiting_);
  bytes_.resize(end_);
}

}  // namespace wuerfel
