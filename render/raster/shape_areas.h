/// What a shape covers of the pixels of a row: the geometry of our own rasteriser. Coverage is that of a
/// pixel's distance to the shape's edge, as in the shaders of OSMesa.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "render/picture/draw_list.h"

namespace wuerfel::internal {

/// Pixels of a row, from `begin` to before `end`.
struct Span {
  int begin = 0;
  int end = 0;
  [[nodiscard]] int size() const { return end - begin; }
};

/// Part of a row, in pixels.
struct Stretch {
  float from = 0.0F;
  float to = 0.0F;
};

/// The pixels of `all` whose middles lie in a stretch.
inline Span pixels_in(Stretch stretch, Span all) {
  const auto first_from = [&all](float x) {
    // Bounds first: what is no number is the first pixel.
    const float middle =
        std::min(static_cast<float>(all.end), std::max(static_cast<float>(all.begin), x - 0.5F));
    const int below = static_cast<int>(middle);
    return below + static_cast<int>(static_cast<float>(below) < middle);
  };
  return {first_from(stretch.from), first_from(stretch.to)};
}

inline float dot(Pixel a, Pixel b) { return a.x * b.x + a.y * b.y; }
inline float length(Pixel span) { return std::sqrt(dot(span, span)); }
inline Pixel across(Pixel axis) { return {-axis.y, axis.x}; }

/// Where low <= dot(normal, point) <= high, for a normal of length 1.
class Strip {
 public:
  Strip() = default;
  Strip(Pixel normal, float low, float high) {
    if (!(low <= high)) return;  // what is no number is empty, too
    low_ = low;
    high_ = high;
    normal_y_ = normal.y;
    constexpr float flattest = 1e-6F;  // a row of pixels is all inside or all outside
    if (!(std::abs(normal.x) >= flattest)) return;
    inverse_ = 1.0F / normal.x;
    if (inverse_ < 0.0F) std::swap(low_, high_);
  }
  /// Less than `reach` from a point across an axis.
  static Strip around(Pixel center, Pixel axis, float reach) {
    const float middle = dot(center, axis);
    return {axis, middle - reach, middle + reach};
  }
  /// The part of `all` of row y that lies in it.
  [[nodiscard]] Stretch of_row(float y, Stretch all) const {
    const float shift = y * normal_y_;
    if (inverse_ == 0.0F) return low_ <= shift && shift <= high_ ? all : Stretch{};
    return {std::max(all.from, (low_ - shift) * inverse_),
            std::min(all.to, (high_ - shift) * inverse_)};
  }

 private:
  float low_ = 1.0F;  ///< above high: empty
  float high_ = 0.0F;
  float normal_y_ = 0.0F;
  float inverse_ = 0.0F;  ///< 1 / normal.x; 0 where it is too small
};

inline constexpr float far_away = 1e9F;  // px

/// The pixels of `all` in all strips.
inline Span common(std::span<const Strip> strips, float y, Span all) {
  Stretch stretch{-far_away, far_away};
  for (const Strip& strip : strips)
    stretch = strip.of_row(y, stretch);
  return stretch.from < stretch.to ? pixels_in(stretch, all) : Span{};
}

/// By so many pixels areas reach farther than what may be covered, and less far than what is covered wholly.
inline constexpr float safety = 0.05F;

/// How much of a pixel a shape covers, and how much its filling; 0 <= fill <= all <= 1.
struct Coverage {
  float all = 0.0F;
  float fill = 0.0F;
};

inline Coverage even(float share) { return {share, share}; }
inline float clamped(float share) { return std::clamp(share, 0.0F, 1.0F); }

// Each kind of shape tells how it covers the pixel at (x, y), which pixels of a row it may cover, and which
// of these it fills.

class BoxArea {
 public:
  explicit BoxArea(const BoxShape& box);
  [[nodiscard]] Coverage at(float x, float y) const {
    const Pixel p{x - center_.x, y - center_.y};
    const Pixel q{std::abs(dot(p, axis_)), std::abs(dot(p, across(axis_)))};
    const float line = clamped(diagonal_reach_ - std::abs(dot(q, diagonal_))) * diagonal_ink_;
    const float all = ink_ * clamped(outer_reach_.x - q.x) * clamped(outer_reach_.y - q.y);
    const float fill =
        ink_ * clamped(inner_reach_.x - q.x) * clamped(inner_reach_.y - q.y) * (1.0F - line);
    return {all, fill};
  }
  [[nodiscard]] Span touched(float y, Span all) const { return common(outer_, y, all); }
  [[nodiscard]] Span filled(float y, Span all) const { return common(filled_, y, all); }
  /// Pixels within what is filled that the diagonals may cover, from left to right.
  [[nodiscard]] std::array<Span, 2> crossed(float y, Span filled) const {
    if (diagonal_ink_ <= 0.0F) return {};
    std::array spans{common({&diagonals_[0], 1}, y, filled),
                     common({&diagonals_[1], 1}, y, filled)};
    if (spans[1].begin < spans[0].begin) std::swap(spans[0], spans[1]);
    spans[1].begin = std::max(spans[1].begin, spans[0].end);
    return spans;
  }

 private:
  Pixel center_;
  Pixel axis_;
  Pixel outer_reach_;  ///< where coverage ends, from the middle
  Pixel inner_reach_;  ///< the same inside of the outline
  float ink_ = 1.0F;
  Pixel diagonal_;  ///< normal of the diagonal in the first quadrant
  float diagonal_reach_;
  float diagonal_ink_;
  std::array<Strip, 2> outer_;
  std::array<Strip, 2> filled_;
  std::array<Strip, 2> diagonals_;
};

class SegmentArea {
 public:
  explicit SegmentArea(const SegmentShape& segment);
  [[nodiscard]] Coverage at(float x, float y) const {
    const Pixel p{x - middle_.x, y - middle_.y};
    const Pixel q{std::abs(dot(p, axis_)), std::abs(dot(p, across(axis_)))};
    if (!is_round_) return even(overlap(q.x, half_length_) * overlap(q.y, half_width_));
    const float beyond = q.x - half_length_;
    return even(overlap(beyond > 0.0F ? length({beyond, q.y}) : q.y, half_width_));
  }
  [[nodiscard]] Span touched(float y, Span all) const { return common(outer_, y, all); }
  [[nodiscard]] Span filled(float y, Span all) const { return common(filled_, y, all); }

 private:
  /// How much of a pixel at x lies between -half and half.
  static float overlap(float x, float half) {
    return clamped(std::min(x + 0.5F, half) - std::max(x - 0.5F, -half));
  }
  Pixel middle_;
  Pixel axis_{1.0F, 0.0F};
  float half_length_ = 0.0F;
  float half_width_;
  bool is_round_;
  std::array<Strip, 2> outer_;
  std::array<Strip, 2> filled_;
};

/// Shaft and swept-back head as one shape; u runs along the arrow, v >= 0 across.
class ArrowArea {
 public:
  explicit ArrowArea(const ArrowShape& arrow);
  [[nodiscard]] Coverage at(float x, float y) const {
    const Pixel p{x - tail_.x, y - tail_.y};
    const Pixel q{dot(p, axis_), std::abs(dot(p, across(axis_)))};
    const float shaft = std::max(std::max(-q.x, q.x - shaft_end_), q.y - half_width_);
    const float head = std::max(dot(q, slant_) + slant_at_, dot(q, back_) + back_at_);
    return even(clamped(reach_ - std::min(shaft, head)));
  }
  [[nodiscard]] Span touched(float y, Span all) const {
    const Span shaft = common(shaft_, y, all);
    const Span head = common(head_, y, all);
    if (shaft.size() == 0) return head;
    if (head.size() == 0) return shaft;
    return {std::min(shaft.begin, head.begin), std::max(shaft.end, head.end)};
  }
  [[nodiscard]] Span filled(float y, Span all) const {
    const Span shaft = common(filled_shaft_, y, all);
    const Span head = common(filled_head_, y, all);
    return head.size() > shaft.size() ? head : shaft;
  }

 private:
  /// Pixels less than `distance` from the shaft.
  [[nodiscard]] std::array<Strip, 2> shaft_to(float distance) const {
    const float from = dot(tail_, axis_);
    return {Strip(axis_, from - distance, from + shaft_end_ + distance),
            Strip::around(tail_, across(axis_), half_width_ + distance)};
  }
  /// Pixels less than `distance` outside of the head's slanted edges, from u = `from` on; sharp corners end
  /// a `margin` beyond it.
  [[nodiscard]] std::array<Strip, 4> head_to(float distance, float from, float margin) const {
    const auto edge = [&](float side) {
      const Pixel normal{slant_.x * axis_.x - side * slant_.y * axis_.y,
                         slant_.x * axis_.y + side * slant_.y * axis_.x};
      return Strip(normal, -far_away, dot(normal, tail_) - slant_at_ + distance);
    };
    const float tail = dot(tail_, axis_);
    return {edge(1.0F), edge(-1.0F), Strip(axis_, tail + from, tail + length_ + margin),
            Strip::around(tail_, across(axis_), half_head_ + margin)};
  }
  Pixel tail_;
  Pixel axis_;
  float length_;
  float half_width_;
  float half_head_;  ///< px, half of the width of the head, or of the shaft if that is wider
  float reach_;      ///< of coverage beyond the shape
  float shaft_end_ = 0.0F;
  Pixel slant_;  ///< distance from the head's front edge: dot((u, v), slant) + slant_at
  float slant_at_ = 0.0F;
  Pixel back_;  ///< and from its swept-back edge
  float back_at_ = 0.0F;
  std::array<Strip, 2> shaft_;
  std::array<Strip, 4> head_;
  std::array<Strip, 2> filled_shaft_;
  std::array<Strip, 4> filled_head_;
};

class DiscArea {
 public:
  explicit DiscArea(const DiscShape& disc)
      : center_(disc.center), radius_(disc.radius), outline_width_(disc.outline_width) {}
  [[nodiscard]] Coverage at(float x, float y) const {
    const float depth = 0.5F + radius_ - length({x - center_.x, y - center_.y});
    const float fill = clamped(depth - outline_width_);
    return {clamped(depth), fill};
  }
  [[nodiscard]] Span touched(float y, Span all) const {
    return chord(radius_ + 0.5F + safety, y, all);
  }
  [[nodiscard]] Span filled(float y, Span all) const {
    return chord(radius_ - 0.5F - outline_width_ - safety, y, all);
  }

 private:
  static float square(float x) { return x * x; }
  [[nodiscard]] Span chord(float radius, float y, Span all) const {
    const float rest = square(std::max(radius, 0.0F)) - square(y - center_.y);
    if (!(rest > 0.0F)) return {};
    return pixels_in({center_.x - std::sqrt(rest), center_.x + std::sqrt(rest)}, all);
  }
  Pixel center_;
  float radius_;
  float outline_width_;
};

class TriangleArea {
 public:
  explicit TriangleArea(const TriangleShape& shape);
  [[nodiscard]] Coverage at(float x, float y) const {
    float outside = -far_away;
    for (const Edge& edge : edges_)
      outside = std::max(outside, dot(edge.normal, {x, y}) + edge.at);
    const float fill = clamped(0.5F - outside - outline_width_);
    return {clamped(0.5F - outside), fill};
  }
  [[nodiscard]] Span touched(float y, Span all) const { return common(outer_, y, all); }
  [[nodiscard]] Span filled(float y, Span all) const { return common(filled_, y, all); }

 private:
  struct Edge {
    Pixel normal;  ///< outwards
    float at = 0.0F;
  };
  std::array<Edge, 3> edges_;
  float outline_width_;
  std::array<Strip, 5> outer_;
  std::array<Strip, 3> filled_;
};

}  // namespace wuerfel::internal
