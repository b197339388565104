/// Image: RGBA pixels in memory, rows from top to bottom, straight alpha.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "render/picture/color.h"

namespace wuerfel {

/// Rows of an image from `begin` to before `end`, and of these the columns from `left` to before `right`.
struct RowRange {
  int begin = 0;
  int end = 0;
  int left = 0;
  int right = std::numeric_limits<int>::max();  ///< as far as the image goes
  friend bool operator==(const RowRange&, const RowRange&) = default;
};

class Image {
 public:
  Image() = default;
  /// Throws RenderError unless 1 <= width, height <= 16384 (the rasteriser's limit).
  Image(int width, int height, Color color = {255, 255, 255, 255});

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return bytes_.empty(); }

  Color at(int x, int y) const {
    const std::uint8_t* p = bytes_.data() + offset(x, y);
    return {p[0], p[1], p[2], p[3]};
  }
  void set(int x, int y, Color color);

  /// The row `y` as 4 * width bytes R G B A.
  std::uint8_t* row(int y) { return bytes_.data() + offset(0, y); }
  const std::uint8_t* row(int y) const { return bytes_.data() + offset(0, y); }
  std::uint8_t* data() { return bytes_.data(); }
  std::span<const std::uint8_t> bytes() const { return bytes_; }

  /// True where every pixel is opaque: such a picture is written without an alpha channel.
  bool opaque() const;

  friend bool operator==(const Image&, const Image&) = default;

 private:
  std::size_t offset(int x, int y) const { return 4 * (y * width_ + x); }

  int width_ = 0;
  int height_ = 0;
  std::vector<std::uint8_t> bytes_;
};

/// Copies `source` into `target` with its upper left corner at (x, y); what lies outside is cut
/// off.
void paste(const Image& source, int x, int y, Image& target);

/// A number that stands for size and pixels (FNV-1a, 64 bits), equal on every machine.
std::uint64_t pixel_hash(const Image& image);

}  // namespace wuerfel
