#include "render/raster/image.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "render/error.h"

namespace wuerfel {
namespace {

constexpr int largest_side = 16384;

}  // namespace

Image::Image(int width, int height, Color color) : width_(width), height_(height) {
  if (width < 1 || height < 1 || width > largest_side || height > largest_side) {
    throw RenderError("a picture of " + std::to_string(width) + "x" + std::to_string(height)
                      + " pixels is not possible: each side must be 1 to "
                      + std::to_string(largest_side));
  }
  bytes_.resize(offset(0, height));
  for (int x = 0; x < width; ++x)
    set(x, 0, color);
  for (int y = 1; y < height; ++y)
    std::copy_n(row(0), offset(0, 1), row(y));
}

void Image::set(int x, int y, Color color) {
  std::uint8_t* p = bytes_.data() + offset(x, y);
  p[0] = color.r;
  p[1] = color.g;
  p[2] = color.b;
  p[3] = color.a;
}

bool Image::opaque() const {
  for (int y = 0; y < height_; ++y) {
    // Whole words, without a branch, so that the compiler can take many at once.
    std::uint32_t all = 0xFFFFFFFFU;
    const std::uint8_t* pixel = row(y);
    for (int x = 0; x < width_; ++x) {
      std::uint32_t word = 0;
      std::memcpy(&word, pixel + 4 * static_cast<std::ptrdiff_t>(x), 4);
      all &= word;
    }
    std::uint8_t alpha = 0;
    std::memcpy(&alpha, reinterpret_cast<const std::uint8_t*>(&all) + 3, 1);
    if (alpha != 255) return false;
  }
  return true;
}

void paste(const Image& source, int x, int y, Image& target) {
  const int from = std::max(0, -x);
  const int to = std::min(source.width(), target.width() - x);
  if (from >= to) return;
  for (int row = std::max(0, -y); row < std::min(source.height(), target.height() - y); ++row) {
    std::copy(source.row(row) + 4 * static_cast<std::ptrdiff_t>(from),
              source.row(row) + 4 * static_cast<std::ptrdiff_t>(to),
              target.row(row + y) + 4 * static_cast<std::ptrdiff_t>(from + x));
  }
}

std::uint64_t pixel_hash(const Image& image) {
  constexpr std::uint64_t offset_basis = 0xCBF29CE484222325U;
  constexpr std::uint64_t prime = 0x100000001B3U;
  std::uint64_t hash = offset_basis;
  const auto mix_in = [&hash](std::uint8_t byte) { hash = (hash ^ byte) * prime; };
  for (const int side : {image.width(), image.height()}) {
    for (int shift = 0; shift < 32; shift += 8) {
      mix_in(static_cast<std::uint8_t>((static_cast<std::uint32_t>(side) >> shift) & 0xFFU));
    }
  }
  for (const std::uint8_t byte : image.bytes())
    mix_in(byte);
  return hash;
}

}  // namespace wuerfel
