/// Marks that several layers are made of. Widths are in pixels of a 1280x720 picture.
#pragma once

#include <string>
#include <vector>

#include "render/picture/frame_parts.h"

namespace wuerfel::internal {

constexpr double mark_arrow_length = 64.0;  ///< px

/// Where a box is and how large in pixels; its colours are its caller's.
BoxShape box_shape(const View& view, const SnapshotBox& box);
/// Halos first, then the strokes.
void add_strokes(const FrameParts& parts, const std::vector<SegmentShape>& strokes);
/// A box with an outline inside.
void frame_box(
    const FrameParts& parts, const SnapshotBox& box, double width, Color line, Color fill);
/// Labels keep off what the next three draw.
void add_disc(const FrameParts& parts, const Vec2& at, double radius, Color fill, Color outline);
void add_stroke(const FrameParts& parts, Pixel from, Pixel to, double width, Color color);
void add_dashes(
    const FrameParts& parts, const Vec2& from, const Vec2& to, double width, Color color);
Pixel moved(Pixel pixel, const Vec2& way);
/// An arrow of a direction in the world, `length` px, from a place on.
ArrowShape arrow_from(
    const FrameParts& parts, const Vec2& at, const Vec2& way, double length, Color color);
/// A label beside a place, wherever there is room; below it first.
void add_label(const FrameParts& parts, const std::string& text, Pixel at, Color color);

}  // namespace wuerfel::internal
