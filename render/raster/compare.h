/// Comparing pictures: equal, near enough, or different. Used by `wuerfel compare` and by our own
/// golden tests.
#pragma once

#include <string>
#include <string_view>

#include "render/picture/font.h"
#include "render/raster/image.h"

namespace wuerfel {

/// What still counts as the same picture. The pixels of one machine are equal from run to run;
/// without fused multiply-add 0.1 % of them differ by 1, on another rasteriser 4 % by up to 3.
/// There is deliberately no mean or structural measure: a missing arrow is a ten-thousandth of a
/// picture.
struct CompareLimits {
  int largest_difference = 4;   ///< of any channel of any pixel, 0..255
  double largest_share = 0.05;  ///< of pixels that differ at all
};

enum class CompareVerdict { identical, near_enough, different };
std::string_view to_string(CompareVerdict verdict);

struct Comparison {
  CompareVerdict verdict = CompareVerdict::identical;
  bool same_size = true;
  long changed = 0;            ///< pixels that differ
  double share = 0.0;          ///< of all pixels; 1 where the sizes differ
  int largest_difference = 0;  ///< of any channel
  int worst_x = 0;             ///< where that is
  int worst_y = 0;
  /// Smallest rectangle around all differences: left, top (inclusive), right, bottom (exclusive).
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
};

/// Colours of fully transparent pixels are not compared: nobody sees them.
Comparison compare_images(const Image& expected,
                          const Image& actual,
                          const CompareLimits& limits = {});

/// One line for people: "different: 1234 pixels (0.4 %), largest difference 200 at (17, 23), within
/// 40x12+10+20".
std::string describe(const Comparison& comparison);

/// A pale grey copy of `expected`; yellow where `actual` differs within the limit, red beyond it.
Image difference_picture(const Image& expected,
                         const Image& actual,
                         const CompareLimits& limits = {});

/// expected | actual | difference with their names above, for a human eye; one below the other
/// where they would be wider than an image can be.
Image side_by_side(const Image& expected,
                   const Image& actual,
                   const CompareLimits& limits,
                   Font& font);

}  // namespace wuerfel
