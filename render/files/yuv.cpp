#include "render/files/yuv.h"

#include <algorithm>
#include <cstring>

namespace wuerfel::internal {
namespace {

// BT.709 with K_R = 0.2126, K_B = 0.0722, in units of 2^-16; each chroma row sums to zero, so that
// grey has none.
constexpr int shift = 16;
constexpr int y_r = 11966;
constexpr int y_g = 40254;
constexpr int y_b = 4064;
constexpr int u_r = -6596;
constexpr int u_g = -22189;
constexpr int u_b = 28785;
constexpr int v_r = 28785;
constexpr int v_g = -26145;
constexpr int v_b = -2640;

void luma_row(const std::uint8_t* rgba, int width, std::uint8_t* luma) {
  constexpr int offset = (16 << shift) + (1 << (shift - 1));
  for (int x = 0; x < width; ++x) {
    const std::uint8_t* p = rgba + 4 * static_cast<std::ptrdiff_t>(x);
    luma[x] = static_cast<std::uint8_t>((y_r * p[0] + y_g * p[1] + y_b * p[2] + offset) >> shift);
  }
}

/// One row of U and V from two rows of pixels.
void chroma_row(const std::uint8_t* upper,
                const std::uint8_t* lower,
                int width,
                std::uint8_t* u,
                std::uint8_t* v) {
  constexpr int offset = (128 << (shift + 2)) + (1 << (shift + 1));
  for (int x = 0; x < width; x += 2) {
    const std::ptrdiff_t left = 4 * static_cast<std::ptrdiff_t>(x);
    const std::ptrdiff_t right = x + 1 < width ? left + 4 : left;
    const int r = upper[left] + upper[right] + lower[left] + lower[right];
    const int g = upper[left + 1] + upper[right + 1] + lower[left + 1] + lower[right + 1];
    const int b = upper[left + 2] + upper[right + 2] + lower[left + 2] + lower[right + 2];
    u[x / 2] = static_cast<std::uint8_t>((u_r * r + u_g * g + u_b * b + offset) >> (shift + 2));
    v[x / 2] = static_cast<std::uint8_t>((v_r * r + v_g * g + v_b * b + offset) >> (shift + 2));
  }
}

}  // namespace

void append_yuv420(const Image& image, std::vector<std::uint8_t>& planes) {
  const std::ptrdiff_t width = even_size(image.width());
  const std::ptrdiff_t height = even_size(image.height());
  const std::size_t start = planes.size();
  planes.resize(start + static_cast<std::size_t>(width * height + width * height / 2));
  std::uint8_t* luma = planes.data() + start;
  std::uint8_t* u = luma + width * height;
  std::uint8_t* v = u + width * height / 4;
  const int last = image.height() - 1;
  const auto row_bytes = 4 * image.width();
  // Most rows of a picture of flat shapes equal the one above.
  const auto equals_above = [&](int y) {
    return y > 0 && std::memcmp(image.row(y), image.row(y - 1), row_bytes) == 0;
  };
  int equal_rows = 0;  // that end above the row at hand, which equals them too
  for (int y = 0; y < height; ++y) {
    std::uint8_t* row = luma + y * width;
    equal_rows = y > last || equals_above(y) ? equal_rows + 1 : 0;
    if (equal_rows > 0) {
      std::copy_n(row - width, width, row);
    } else {
      luma_row(image.row(y), image.width(), row);
      if (width > image.width()) row[width - 1] = row[width - 2];
    }
    if (y % 2 == 0) continue;
    const std::ptrdiff_t chroma = y / 2 * (width / 2);
    if (equal_rows >= 3) {
      std::copy_n(u + chroma - width / 2, width / 2, u + chroma);
      std::copy_n(v + chroma - width / 2, width / 2, v + chroma);
    } else {
      chroma_row(image.row(y - 1), image.row(std::min(y, last)), image.width(), u + chroma,
                 v + chroma);
    }
  }
}

}  // namespace wuerfel::internal
