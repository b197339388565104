#include "render/files/isal_deflate.h"

#include <algorithm>
#include <array>
#include <cstring>
#if defined(__x86_64__)
#include <tmmintrin.h>
#endif
#include <zlib.h>

#include "render/error.h"
#include "render/files/isal_library.h"
#include "render/files/png_chunks.h"

namespace wuerfel::internal {
namespace {

/// The dynamic codes of levels 1 to 3 are not always the same for the same bytes.
constexpr int level = 0;
constexpr int band_size = 1 << 18;  ///< bytes; a band has at least one row

/// What is the same for all bands of a picture.
struct Layout {
  int width = 0;
  int height = 0;
  int channels = 0;
  friend bool operator==(const Layout&, const Layout&) = default;

  int row_size() const { return 1 + channels * width; }
  int band_rows() const { return std::max(1, band_size / row_size()); }
  int bands() const { return (height + band_rows() - 1) / band_rows(); }
};

struct Band {
  std::vector<std::uint8_t> packed;  ///< whole deflate blocks, none of them the last
  std::uint32_t adler = 0;
  int size = 0;  ///< bytes before packing
};

/// Two pixels at a time: six of eight bytes, of which the last two are overwritten by the next.
void pack_pairs(const std::uint8_t* rgba, int width, std::uint8_t* rgb) {
  constexpr std::uint64_t first = 0xFFFFFFU;
  constexpr std::uint64_t second = first << 24U;
  int x = 0;
  for (; x + 2 < width; x += 2, rgba += 8, rgb += 6) {
    std::uint64_t two = 0;
    std::memcpy(&two, rgba, 8);
    two = (two & first) | ((two >> 8U) & second);
    std::memcpy(rgb, &two, 8);
  }
  for (; x < width; ++x, rgba += 4, rgb += 3)
    std::memcpy(rgb, rgba, 3);
}

#if defined(__x86_64__)
/// Four at a time, where a register's bytes can be put in another order: the first twelve of sixteen.
[[gnu::target("ssse3")]] void pack_fours(const std::uint8_t* rgba, int width, std::uint8_t* rgb) {
  const __m128i order = _mm_setr_epi8(0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, -1, -1, -1, -1);
  int x = 0;
  // What four pixels write beyond their own twelve bytes belongs to the next two.
  for (; x + 6 <= width; x += 4, rgba += 16, rgb += 12) {
    const __m128i four = _mm_loadu_si128(reinterpret_cast<const __m128i*>(rgba));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(rgb), _mm_shuffle_epi8(four, order));
  }
  pack_pairs(rgba, width - x, rgb);
}
#endif

void pack_rgb(const std::uint8_t* rgba, int width, std::uint8_t* rgb) {
#if defined(__x86_64__)
  static const bool fours = __builtin_cpu_supports("ssse3");
  if (fours) return pack_fours(rgba, width, rgb);
#endif
  pack_pairs(rgba, width, rgb);
}

}  // namespace

struct IsalDeflate::Workspace {
  const IsalLibrary& isal = isal_library();
  isal_zstream stream{};
  std::vector<std::uint8_t> rows;    ///< of the picture, as PNG wants them
  std::vector<std::uint8_t> output;  ///< as large as a band can become
  Layout layout;
  std::vector<Band> bands;  ///< of the picture before

  void lay_out(const Layout& wanted);
  void take(const Image& image, const RowRange& changed);
  void pack(int first, int last, Band& band);
};

void IsalDeflate::Workspace::lay_out(const Layout& wanted) {
  layout = wanted;
  bands.assign(layout.bands(), Band());
  const int most = layout.band_rows() * layout.row_size();
  rows.assign(static_cast<std::size_t>(layout.height) * layout.row_size(), 0);  // 0: no filter
  constexpr int blocks = 1024;  // what is longer than it was is stored in blocks with a header each
  output.resize(most + most / 64 + blocks);
}

void IsalDeflate::Workspace::take(const Image& image, const RowRange& changed) {
  const int width = std::min(changed.right, layout.width) - changed.left;
  for (int y = changed.begin; y < changed.end; ++y) {
    const std::uint8_t* pixels = image.row(y) + 4 * static_cast<std::ptrdiff_t>(changed.left);
    std::uint8_t* row = rows.data() + static_cast<std::ptrdiff_t>(y) * layout.row_size() + 1
                        + static_cast<std::ptrdiff_t>(layout.channels) * changed.left;
    if (layout.channels == 4) {
      std::memcpy(row, pixels, 4 * static_cast<std::size_t>(width));
    } else {
      pack_rgb(pixels, width, row);
    }
  }
}

void IsalDeflate::Workspace::pack(int first, int last, Band& band) {
  std::uint8_t* const begin = rows.data() + static_cast<std::ptrdiff_t>(first) * layout.row_size();
  band.size = (last - first) * layout.row_size();
  band.adler = isal.adler32(1, begin, band.size);
  isal.deflate_init(&stream);
  stream.level = level;
  stream.flush = FULL_FLUSH;  // ends with a whole byte, and the next band looks no further back
  stream.next_in = begin;
  stream.avail_in = static_cast<std::uint32_t>(band.size);
  stream.next_out = output.data();
  stream.avail_out = static_cast<std::uint32_t>(output.size());
  if (const int problem = isal.deflate(&stream); problem != COMP_OK)
    throw LibraryError("ISA-L reports error " + std::to_string(problem));
  band.packed.assign(output.data(), stream.next_out);
}

IsalDeflate::IsalDeflate() : work_(std::make_unique<Workspace>()) {}

IsalDeflate::~IsalDeflate() = default;

void IsalDeflate::compress(const Image& image,
                           int channels,
                           RowSet changed,
                           std::vector<std::uint8_t>& stream) {
  const Layout layout{image.width(), image.height(), channels};
  if (layout != work_->layout) {
    work_->lay_out(layout);
    changed = RowRange{0, image.height()};
  }
  for (const RowRange& range : changed.ranges())
    work_->take(image, range);
  stream.assign({0x78, 0x01});  // zlib's header: deflate, fast
  std::uint32_t adler = 1;
  for (int first = 0, i = 0; first < image.height(); first += layout.band_rows(), ++i) {
    const int last = std::min(first + layout.band_rows(), image.height());
    Band& band = work_->bands[i];
    if (changed.touches({first, last})) work_->pack(first, last, band);
    stream.insert(stream.end(), band.packed.begin(), band.packed.end());
    adler = static_cast<std::uint32_t>(adler32_combine(adler, band.adler, band.size));
  }
  stream.insert(stream.end(), {0x01, 0x00, 0x00, 0xFF, 0xFF});  // the last block: nothing
  append_u32(adler, stream);
}

std::uint32_t isal_crc32(std::uint32_t start, const std::vector<std::uint8_t>& bytes) {
  return isal_library().crc32(start, bytes.data(), bytes.size());
}

}  // namespace wuerfel::internal
