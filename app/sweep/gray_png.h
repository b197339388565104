/// PNG files of numbers: one grey channel, no more.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace wuerfel {

/// A number per pixel, rows from top to bottom.
struct NumberImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint16_t> values;
};

/// 8 bits per pixel, or 16 where one of the numbers needs them. Equal masks give equal bytes for one
/// version of zlib.
std::string gray_png(const NumberImage& image);

}  // namespace wuerfel
