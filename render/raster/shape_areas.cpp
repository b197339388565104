#include "render/raster/shape_areas.h"

namespace wuerfel::internal {

BoxArea::BoxArea(const BoxShape& box)
    : center_(box.center),
      axis_(box.axis),
      diagonal_reach_(std::max(0.5F * box.diagonal_width, 0.5F) + 0.5F),
      diagonal_ink_(std::min(box.diagonal_width, 1.0F)) {
  const Pixel half = box.half_size;
  // What is narrower than a pixel is drawn one pixel wide and fades, so that its ink stays right.
  outer_reach_ = {std::max(half.x, 0.5F) + 0.5F, std::max(half.y, 0.5F) + 0.5F};
  inner_reach_ = {outer_reach_.x - box.outline_width, outer_reach_.y - box.outline_width};
  ink_ = std::min(2.0F * half.x, 1.0F) * std::min(2.0F * half.y, 1.0F);
  const float diameter = std::max(length(half), 1e-6F);
  diagonal_ = {half.y / diameter, -half.x / diameter};
  outer_ = {Strip::around(box.center, box.axis, outer_reach_.x + safety),
            Strip::around(box.center, across(box.axis), outer_reach_.y + safety)};
  const float edge = 1.0F + safety;
  filled_ = {Strip::around(box.center, box.axis, inner_reach_.x - edge),
             Strip::around(box.center, across(box.axis), inner_reach_.y - edge)};
  const auto diagonal_strip = [&](float side) {
    const Pixel normal{diagonal_.x * axis_.x - side * diagonal_.y * axis_.y,
                       diagonal_.x * axis_.y + side * diagonal_.y * axis_.x};
    return Strip::around(center_, normal, diagonal_reach_ + safety);
  };
  diagonals_ = {diagonal_strip(1.0F), diagonal_strip(-1.0F)};
}

SegmentArea::SegmentArea(const SegmentShape& segment)
    : middle_{0.5F * (segment.from.x + segment.to.x), 0.5F * (segment.from.y + segment.to.y)},
      half_width_(segment.half_width),
      is_round_(segment.round > 0.5F) {
  const Pixel span{segment.to.x - segment.from.x, segment.to.y - segment.from.y};
  const float reach = length(span);
  if (reach > 0.0F) axis_ = {span.x / reach, span.y / reach};
  half_length_ = 0.5F * reach;
  const float end = half_length_ + (is_round_ ? half_width_ : 0.0F);
  outer_ = {Strip::around(middle_, axis_, end + 0.5F + safety),
            Strip::around(middle_, across(axis_), half_width_ + 0.5F + safety)};
  filled_ = {Strip::around(middle_, axis_, half_length_ - 0.5F - safety),
             Strip::around(middle_, across(axis_), half_width_ - 0.5F - safety)};
}

ArrowArea::ArrowArea(const ArrowShape& arrow)
    : tail_(arrow.tail),
      length_(length({arrow.tip.x - arrow.tail.x, arrow.tip.y - arrow.tail.y})),
      half_width_(arrow.half_width),
      half_head_(std::max(arrow.half_width, arrow.head_half_width)),
      reach_(0.5F + arrow.grow) {
  const float divisor = std::max(length_, 1e-6F);
  axis_ = {(arrow.tip.x - arrow.tail.x) / divisor, (arrow.tip.y - arrow.tail.y) / divisor};
  const float head = arrow.head_length;
  const float wing = arrow.head_half_width;
  const float notch = 0.25F * head;
  const float base = length_ - head;
  shaft_end_ = base + notch;
  const float slanted = length({wing, head});
  slant_ = {wing / slanted, head / slanted};
  slant_at_ = -length_ * slant_.x;
  const float swept = length({wing, notch});
  back_ = {-wing / swept, -notch / swept};
  back_at_ = -shaft_end_ * back_.x;
  // The grown head's corners run ahead of the head by up to 3.2 times the growth.
  const float margin = 3.5F * std::max(arrow.grow, 0.0F) + 1.0F;
  shaft_ = shaft_to(reach_ + safety);
  head_ = head_to(reach_ + safety, base - margin, margin);
  const float whole = reach_ - 1.0F - safety;
  filled_shaft_ = shaft_to(whole);
  filled_head_ = head_to(whole, shaft_end_ - whole * swept / wing, margin);
}

TriangleArea::TriangleArea(const TriangleShape& shape) : outline_width_(shape.outline_width) {
  const Pixel ab{shape.b.x - shape.a.x, shape.b.y - shape.a.y};
  const Pixel ac{shape.c.x - shape.a.x, shape.c.y - shape.a.y};
  const float turn = dot(across(ab), ac) > 0.0F ? -1.0F : 1.0F;
  const std::array<Pixel, 4> corners{shape.a, shape.b, shape.c, shape.a};
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    const Pixel side{corners[k + 1].x - corners[k].x, corners[k + 1].y - corners[k].y};
    const float scale = turn / length(side);
    const Pixel normal{-side.y * scale, side.x * scale};
    edges_[k] = {normal, -dot(normal, corners[k])};
    outer_[k] = Strip(normal, -far_away, 0.5F + safety - edges_[k].at);
    filled_[k] = Strip(normal, -far_away, -0.5F - outline_width_ - safety - edges_[k].at);
  }
  // Sharp corners end a pixel beyond the triangle.
  const auto [left, right] = std::minmax({shape.a.x, shape.b.x, shape.c.x});
  const auto [top, bottom] = std::minmax({shape.a.y, shape.b.y, shape.c.y});
  outer_[3] = Strip({1.0F, 0.0F}, left - 1.0F, right + 1.0F);
  outer_[4] = Strip({0.0F, 1.0F}, top - 1.0F, bottom + 1.0F);
}

}  // namespace wuerfel::internal
