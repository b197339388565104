#include "app/sweep/gray_png.h"

#include <algorithm>
#include <string_view>
#include <zlib.h>

#include "app/sweep/digest.h"

namespace wuerfel {

namespace {

void put(std::string& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes += static_cast<char>(value >> static_cast<unsigned>(shift) & 0xffU);
}

// Length, type, content, CRC [PNG 5.3].
void put_chunk(std::string& png, std::string_view type, std::string_view content) {
  put(png, static_cast<std::uint32_t>(content.size()));
  const std::string body = std::string(type) + std::string(content);
  png += body;
  put(png, crc32_of(body));
}

std::string header(const NumberImage& image, int bits) {
  std::string content;
  put(content, static_cast<std::uint32_t>(image.width));
  put(content, static_cast<std::uint32_t>(image.height));
  content += static_cast<char>(bits);
  content.append(4, '\0');  // grey; deflate; adaptive filters; not interlaced
  return content;
}

// Rows of large uniform areas: no filter serves them better than none.
std::string rows(const NumberImage& image, int bits) {
  const std::size_t row = 1 + static_cast<std::size_t>(image.width) * (bits > 8 ? 2 : 1);
  std::string bytes(row * static_cast<std::size_t>(image.height), '\0');
  char* next = bytes.data();
  auto value = image.values.begin();
  for (int y = 0; y < image.height; ++y) {
    ++next;
    for (int x = 0; x < image.width; ++x, ++value) {
      if (bits > 8) *next++ = static_cast<char>(*value >> 8U);
      *next++ = static_cast<char>(*value & 0xffU);
    }
  }
  return bytes;
}

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
            reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 6);
  packed.resize(size);
  return packed;
}

}  // namespace

std::string gray_png(const NumberImage& image) {
  const bool small = std::ranges::all_of(image.values, [](auto value) { return value < 256; });
  const int bits = small ? 8 : 16;
  std::string png = "\x89PNG\r\n\x1a\n";
  put_chunk(png, "IHDR", header(image, bits));
  put_chunk(png, "IDAT", deflated(rows(image, bits)));
  put_chunk(png, "IEND", "");
  return png;
}

}  // namespace wuerfel
