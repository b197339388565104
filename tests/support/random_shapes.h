/// Draw lists of shapes at random, for tests of rasterisers.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "render/picture/draw_list.h"

namespace wuerfel::test {

/// Some shapes of every kind at random places, also outside of the picture.
class RandomShapes {
 public:
  explicit RandomShapes(unsigned seed) : random_(seed) {}

  void add_some(DrawList& list) {
    for (int i = 0; i < 3; ++i) {
      const Pixel a = place();
      const Pixel b = place();
      list.add(BoxShape{
          a, axis(), {size(), size()}, 2.0F, size() > 12.0F ? 1.0F : 0.0F, color(), color()});
      list.add(SegmentShape{a, b, 0.1F * size(), size() > 12.0F ? 1.0F : 0.0F, color()});
      list.add(ArrowShape{a, b, 2.0F, 10.0F, 5.0F, size() > 12.0F ? 1.5F : 0.0F, color()});
      list.add(DiscShape{b, size(), 2.0F, color(), color()});
      list.add(TriangleShape{a, b, place(), 1.5F, color(), color()});
    }
  }
  Pixel place() { return {uniform(-20.0F, 220.0F), uniform(-20.0F, 140.0F)}; }

 private:
  float uniform(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random_);
  }
  float size() { return uniform(0.5F, 25.0F); }
  Pixel axis() {
    const float angle = uniform(0.0F, 6.28F);
    return {std::cos(angle), std::sin(angle)};
  }
  Color color() {
    const auto byte = [this] { return static_cast<std::uint8_t>(random_()); };
    return {byte(), byte(), byte(), byte()};
  }
  std::mt19937 random_;
};

}  // namespace wuerfel::test
