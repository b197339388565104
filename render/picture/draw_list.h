/// DrawList: a picture as plain shapes in pixels, in the order in which they are painted. Every
/// backend (scan lines, OSMesa, Cairo) draws the same list, and tests can look at it without drawing.
///
/// Pixels: x to the right, y down, (0, 0) the upper left corner of the picture. Colours have
/// straight alpha.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "render/picture/color.h"

namespace wuerfel {

struct Pixel {
  float x = 0.0F;
  float y = 0.0F;
  friend bool operator==(const Pixel&, const Pixel&) = default;
};

/// A posed rectangle. The outline lies inside, so that touching boxes don't overlap.
struct BoxShape {
  Pixel center;
  Pixel axis{1.0F, 0.0F};  ///< unit vector along the width
  Pixel half_size;
  float outline_width = 0.0F;
  float diagonal_width = 0.0F;  ///< > 0: both diagonals in the outline's colour, inside the outline
  Color fill;
  Color outline;
  friend bool operator==(const BoxShape&, const BoxShape&) = default;
};

/// A straight stroke.
struct SegmentShape {
  Pixel from;
  Pixel to;
  float half_width = 0.5F;
  float round = 1.0F;  ///< 1: round ends, 0: cut off at the end points
  Color color;
  friend bool operator==(const SegmentShape&, const SegmentShape&) = default;
};

/// An arrow with a swept-back head; the shaft ends inside the head.
struct ArrowShape {
  Pixel tail;
  Pixel tip;
  float half_width = 1.0F;
  float head_length = 8.0F;
  float head_half_width = 4.0F;
  float grow = 0.0F;  ///< outline moved outwards by this many pixels: a halo
  Color color;
  friend bool operator==(const ArrowShape&, const ArrowShape&) = default;
};

/// A disc with an outline inside.
struct DiscShape {
  Pixel center;
  float radius = 1.0F;
  float outline_width = 0.0F;
  Color fill;
  Color outline;
  friend bool operator==(const DiscShape&, const DiscShape&) = default;
};

/// A triangle with an outline inside. Its corners may come in either order.
struct TriangleShape {
  Pixel a;
  Pixel b;
  Pixel c;
  float outline_width = 0.0F;
  Color fill;
  Color outline;
  friend bool operator==(const TriangleShape&, const TriangleShape&) = default;
};

/// One line of text, drawn after all shapes.
struct TextShape {
  std::string text;  ///< UTF-8
  Pixel baseline;    ///< where the first letter starts
  float size = 14.0F;
  Color color;
  Color halo;  ///< around the letters
  float halo_width = 0.0F;
  friend bool operator==(const TextShape&, const TextShape&) = default;
};

enum class ShapeKind { box, segment, arrow, disc, triangle };

/// `count` shapes of one kind from `first` on, drawn together.
struct ShapeRun {
  ShapeKind kind = ShapeKind::box;
  std::size_t first = 0;
  std::size_t count = 0;
  friend bool operator==(const ShapeRun&, const ShapeRun&) = default;
};

/// What belongs together, from a shape on: a layer, or a part of one.
struct ShapeGroup {
  std::string_view name;  ///< of static life
  std::size_t shape = 0;  ///< number of its first shape in the painting order
  friend bool operator==(const ShapeGroup&, const ShapeGroup&) = default;
};

/// Box `box` of a list stands for body `body` of its snapshot.
struct BodyBox {
  std::size_t box = 0;
  int body = 0;
  friend bool operator==(const BodyBox&, const BodyBox&) = default;
};

struct DrawList {
  int width = 0;
  int height = 0;
  Color background;
  /// Boxes alone, each pixel whole: in the colour of the last box that has its middle.
  bool exact = false;
  std::vector<BoxShape> boxes;
  std::vector<SegmentShape> segments;
  std::vector<ArrowShape> arrows;
  std::vector<DiscShape> discs;
  std::vector<TriangleShape> triangles;
  std::vector<ShapeRun> runs;      ///< painting order
  std::vector<BodyBox> bodies;     ///< boxes that stand for bodies, in the order of `boxes`
  std::vector<ShapeGroup> groups;  ///< in the painting order
  std::vector<TextShape> texts;
  int labels_left_out = 0;  ///< for want of a free place
  int legend_left_out = 0;  ///< entries that the legend has no room for
  int legend_rows = 0;

  /// Equal lists are equal pictures.
  friend bool operator==(const DrawList&, const DrawList&) = default;

  /// What is added from now on belongs to a group of this name.
  void begin_group(std::string_view name);
  void add(const BoxShape& shape);
  void add(const SegmentShape& shape);
  void add(const ArrowShape& shape);
  void add(const DiscShape& shape);
  void add(const TriangleShape& shape);
};

/// Calls `work` with the shapes of a kind.
template <typename Work>
auto with_shapes(const DrawList& list, ShapeKind kind, const Work& work) {
  switch (kind) {
    case ShapeKind::segment:
      return work(list.segments);
    case ShapeKind::arrow:
      return work(list.arrows);
    case ShapeKind::disc:
      return work(list.discs);
    case ShapeKind::triangle:
      return work(list.triangles);
    case ShapeKind::box:
      break;
  }
  return work(list.boxes);
}

}  // namespace wuerfel
