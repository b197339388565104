#include "render/files/deflate.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <span>

#include "render/files/deflate_block.h"

namespace wuerfel {
namespace {

/// Deflate cannot refer to what lies farther back.
constexpr std::size_t window = 32768;  // bytes
/// A run of this many pixels is worth a match of its own even where the row above agrees for
/// longer: near distances take fewer bits.
constexpr std::size_t long_run = 43;

std::uint64_t load(const std::uint8_t* at) {
  std::uint64_t word = 0;
  std::memcpy(&word, at, sizeof word);
  return word;
}

/// How many of the pixels at `a` and `b` agree before the first that does not; at most `limit`.
std::size_t common_pixels(const std::uint8_t* a, const std::uint8_t* b, std::size_t limit) {
  constexpr std::size_t words = 4;
  constexpr std::size_t at_once = 2 * words;  // pixels
  constexpr std::size_t many =
      64;  // pixels: what is so long goes on to the end more often than not
  std::size_t count = 0;
  while (count + at_once <= limit) {
    std::array<std::uint64_t, words> unlike{};
    for (std::size_t i = 0; i < words; ++i)
      unlike.at(i) = load(a + 4 * count + 8 * i) ^ load(b + 4 * count + 8 * i);
    if ((unlike[0] | unlike[1] | unlike[2] | unlike[3]) != 0) {
      std::size_t i = 0;
      while (unlike.at(i) == 0)
        ++i;
      constexpr std::uint64_t first_pixel = 0xFFFFFFFFU;
      static_assert(std::endian::native == std::endian::little);
      return count + 2 * i + ((unlike.at(i) & first_pixel) == 0 ? 1 : 0);
    }
    count += at_once;
    while (count >= 2 * at_once && count + many <= limit
           && std::memcmp(a + 4 * count, b + 4 * count, 4 * many) == 0)
      count += many;
  }
  while (count < limit && std::memcmp(a + 4 * count, b + 4 * count, 4) == 0)
    ++count;
  return count;
}

/// How many pixels differ before the first that agrees.
std::size_t unlike_pixels(const std::uint8_t* a, const std::uint8_t* b, std::size_t limit) {
  std::size_t count = 0;
  while (count < limit && std::memcmp(a + 4 * count, b + 4 * count, 4) != 0)
    ++count;
  return count;
}

/// Pixels from `begin` up to `end` of a row.
struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The check sum at the end of a zlib stream (RFC 1950): s1 = 1 + sum of bytes, s2 = sum of all s1,
/// modulo 65521. What a row adds follows from what the row above added and the pixels that differ.
class Adler {
 public:
  Adler(std::size_t channels, std::size_t width)
      : channels_(static_cast<std::int64_t>(channels)),
        length_(static_cast<std::int64_t>(1 + channels * width)) {}

  /// The row changes in these pixels, from `above` (null: zeros) to `row`.
  void change(const std::uint8_t* row, const std::uint8_t* above, Span span) {
    constexpr std::array<std::uint8_t, 4> zeros{};
    for (std::size_t x = span.begin; x < span.end; ++x) {
      const std::uint8_t* now = row + 4 * x;
      const std::uint8_t* before = above == nullptr ? zeros.data() : above + 4 * x;
      const std::int64_t r = now[0] - before[0];
      const std::int64_t g = now[1] - before[1];
      const std::int64_t b = now[2] - before[2];
      const std::int64_t alpha = channels_ == 4 ? now[3] - before[3] : 0;
      const std::int64_t all = r + g + b + alpha;
      // The filter byte comes before the pixels.
      const std::int64_t following = length_ - 1 - channels_ * static_cast<std::int64_t>(x);
      sum_ += all;
      weighted_ += following * all - (g + 2 * b + 3 * alpha);
    }
  }
  /// A row is complete.
  void add_row() {
    s2_ = (s2_ + length_ % base * s1_ + weighted_) % base;
    s1_ = (s1_ + sum_) % base;
  }
  std::uint32_t value() const { return static_cast<std::uint32_t>((s2_ << 16) | s1_); }

 private:
  static constexpr std::int64_t base = 65521;
  std::int64_t channels_;
  std::int64_t length_;        ///< bytes of a row
  std::int64_t sum_ = 0;       ///< of the bytes of the row
  std::int64_t weighted_ = 0;  ///< of the bytes times how many follow, itself included
  std::int64_t s1_ = 1;
  std::int64_t s2_ = 0;
};

/// Turns rows into steps.
class RowEncoder {
 public:
  RowEncoder(const Image& image, std::size_t row_bytes)
      : width_(image.width()), reach_above_(row_bytes <= window) {}

  /// A row that differs from the one above in the pixels of `unlike` (from left to right) and there
  /// alone.
  void encode(const std::uint8_t* row, std::size_t number, std::span<const Span> unlike);
  /// A row that equals the one above.
  std::span<const DeflateStep> repeated(const DeflateBlocks& blocks);
  std::span<const DeflateStep> steps() const { return steps_; }

 private:
  void match(std::size_t pixels, bool above) {
    step_.match = static_cast<std::uint16_t>(pixels);
    step_.above = above;
    steps_.push_back(step_);
    step_ = {};
  }

  std::size_t width_;
  bool reach_above_;
  DeflateStep step_;  ///< being made
  std::vector<DeflateStep> steps_;
};

void RowEncoder::encode(const std::uint8_t* row, std::size_t number, std::span<const Span> unlike) {
  steps_.clear();
  step_ = {};
  step_.row_begin = true;
  for (std::size_t x = 0; x < width_;) {
    while (!unlike.empty() && unlike.front().end <= x)
      unlike = unlike.subspan(1);
    const std::size_t next_unlike = unlike.empty() ? width_ : std::max(unlike.front().begin, x);
    const std::size_t up = reach_above_ ? next_unlike - x : 0;
    const std::uint8_t* at = row + 4 * x;
    const std::size_t run = x == 0 ? 0 : common_pixels(at, at - 4, width_ - x);
    if (run >= long_run || (run > 0 && run >= up)) {
      match(run, false);
      x += run;
    } else if (up > 0) {
      match(up, true);
      x += up;
    } else {
      if (step_.literal == 0) step_.first = static_cast<std::uint32_t>(number * width_ + x);
      ++step_.literal;
      ++x;
    }
  }
  if (step_.literal > 0 || step_.row_begin) steps_.push_back(step_);
}

/// Either all of it from above, or once more the steps of the row above, whichever is shorter.
std::span<const DeflateStep> RowEncoder::repeated(const DeflateBlocks& blocks) {
  DeflateStep all;
  all.row_begin = true;
  all.above = true;
  all.match = static_cast<std::uint16_t>(width_);
  if (reach_above_ && blocks.estimate({&all, 1}) < blocks.estimate(steps_)) steps_ = {all};
  return steps_;
}

/// The pixels in which a row differs from the one above.
void find_unlike(const std::uint8_t* row,
                 const std::uint8_t* above,
                 std::size_t width,
                 std::vector<Span>& unlike) {
  unlike.clear();
  if (std::memcmp(row, above, 4 * width) == 0) return;
  for (std::size_t x = 0; x < width;) {
    x += common_pixels(row + 4 * x, above + 4 * x, width - x);
    const std::size_t count = unlike_pixels(row + 4 * x, above + 4 * x, width - x);
    if (count > 0) unlike.push_back({x, x + count});
    x += count;
  }
}

}  // namespace

void deflate_image(const Image& image, int channels, std::vector<std::uint8_t>& bytes) {
  const auto width = static_cast<std::size_t>(image.width());
  const auto bytes_per_pixel = static_cast<std::size_t>(channels);
  const std::size_t row_bytes = 1 + width * bytes_per_pixel;
  bytes = {0x78, 0x01};
  DeflateBlocks blocks(image, bytes_per_pixel, std::min(row_bytes, window), bytes);
  RowEncoder encoder(image, row_bytes);
  Adler adler(bytes_per_pixel, width);
  std::vector<Span> unlike{{0, width}};  // the first row has nothing above
  for (int y = 0; y < image.height(); ++y) {
    const std::uint8_t* above = y == 0 ? nullptr : image.row(y - 1);
    if (y > 0) find_unlike(image.row(y), above, width, unlike);
    for (const Span& span : unlike)
      adler.change(image.row(y), above, span);
    adler.add_row();
    if (unlike.empty()) {
      encoder.repeated(blocks);
    } else {
      encoder.encode(image.row(y), static_cast<std::size_t>(y), unlike);
    }
    for (const DeflateStep& step : encoder.steps())
      blocks.add(step);
  }
  blocks.finish();
  for (const unsigned shift : {24U, 16U, 8U, 0U}) {
    bytes.push_back(static_cast<std::uint8_t>(adler.value() >> shift));
  }
}

}  // namespace wuerfel
