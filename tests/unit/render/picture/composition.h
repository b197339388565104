/// A frame of a pyramid, and what tests ask of its draw list.
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include <gtest/gtest.h>

#include "render/picture/compose_frame.h"
#include "tests/support/image_scenes.h"

namespace wuerfel::test {

inline bool is_upright(const SegmentShape& s) { return s.from.x == s.to.x && s.from.y != s.to.y; }

class Composition : public ::testing::Test {
 protected:
  DrawList compose(Layers layers) {
    options.layers = layers;
    view = literal_view(snapshot, style, options, 640, 360);
    return compose_frame(snapshot, view, style, options, font);
  }
  /// Arrows of a colour without their halos.
  std::vector<ArrowShape> arrows_of(const DrawList& list, Color color) const {
    std::vector<ArrowShape> found;
    std::ranges::copy_if(list.arrows, std::back_inserter(found), [color](const ArrowShape& arrow) {
      return arrow.color == color && arrow.grow == 0.0F;
    });
    return found;
  }

  Snapshot snapshot = pyramid_snapshot();
  Style style = make_style(Theme::light);
  FrameOptions options = literal_options(default_layers);
  View view;
  Font font;
};

inline double length(const ArrowShape& arrow) {
  return std::hypot(static_cast<double>(arrow.tip.x - arrow.tail.x),
                    static_cast<double>(arrow.tip.y - arrow.tail.y));
}

}  // namespace wuerfel::test
