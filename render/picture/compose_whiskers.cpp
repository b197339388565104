// What forces could be instead: from the least to the most along each arrow that is not the only one.
#include <algorithm>
#include <cmath>

#include "render/picture/frame_parts.h"

namespace wuerfel::internal {
namespace {

// Pixels of a 1280x720 picture.
constexpr double line_width = 1.5;
constexpr double bar_reach = 5.5;
constexpr double chevron = 4.5;
constexpr double beside = 12.0;  ///< from the middle of the arrow

/// A line with a bar at each end, or an arrow's point where it goes on.
struct Whisker {
  Pixel least;
  Pixel most;
  bool goes_on = false;  ///< the most is farther than it is drawn
};

class WhiskerPen {
 public:
  WhiskerPen(const FrameParts& parts, const Whisker& whisker) : parts_(parts), at_(whisker) {
    const float x = whisker.most.x - whisker.least.x;
    const float y = whisker.most.y - whisker.least.y;
    const float length = std::hypot(x, y);
    along_ = length > 0.0F ? Pixel{x / length, y / length} : Pixel{0.0F, 1.0F};
  }

  void paint(double width, Color color) const {
    stroke(at_.least, at_.most, width, color);
    if (at_.least != at_.most) bar(at_.least, width, color);
    if (!at_.goes_on) return bar(at_.most, width, color);
    const float size = parts_.weight(chevron);
    for (const float side : {-1.0F, 1.0F})
      stroke(at_.most, place(at_.most, -size, side * size), width, color);
  }

 private:
  [[nodiscard]] Pixel place(Pixel from, float along, float across) const {
    return {from.x + along * along_.x - across * along_.y,
            from.y + along * along_.y + across * along_.x};
  }
  void stroke(Pixel from, Pixel to, double width, Color color) const {
    parts_.list.add(SegmentShape{from, to, 0.5F * parts_.weight(width), 1.0F, color});
  }
  void bar(Pixel at, double width, Color color) const {
    const float reach = parts_.weight(bar_reach);
    stroke(place(at, 0.0F, -reach), place(at, 0.0F, reach), width, color);
  }

  const FrameParts& parts_;
  Whisker at_;
  Pixel along_;
};

void paint(const FrameParts& parts, const std::vector<Whisker>& whiskers) {
  const double wide = line_width + 1.6 * parts.style.halo_width;
  for (const Whisker& whisker : whiskers)
    if (parts.style.halo.a > 0) WhiskerPen(parts, whisker).paint(wide, parts.style.halo);
  for (const Whisker& whisker : whiskers) {
    WhiskerPen(parts, whisker).paint(line_width, parts.style.whisker);
    parts.labels.keep_off(whisker.least, whisker.most,
                          static_cast<double>(parts.weight(bar_reach)));
  }
}

/// To the right of the way from one place to another, as seen on the screen.
Whisker moved_beside(const FrameParts& parts, const Vec2& direction, Whisker whisker) {
  const auto x = static_cast<float>(beside * parts.unit * parts.fineness * direction.y());
  const auto y = static_cast<float>(beside * parts.unit * parts.fineness * direction.x());
  for (Pixel* end : {&whisker.least, &whisker.most}) {
    end->x += x;
    end->y += y;
  }
  return whisker;
}

/// Both ends where the tails of arrows so large are, that push from within the body below.
Whisker whisker_of(const FrameParts& parts, const SnapshotJoint& joint) {
  const auto arrow = [&](double newton) {
    SnapshotJoint of = joint;
    of.force = newton * joint.normal;
    return joint_arrow(parts.snapshot, of, parts.options.force_scale);
  };
  constexpr double endless = 1e150;  // N, whose square is a number
  const JointArrow most = arrow(std::min(joint.range->most, endless));
  return moved_beside(
      parts, joint.normal,
      {parts.pixel(arrow(joint.range->least).tail), parts.pixel(most.tail), most.cut});
}

/// Both ends where the tips of arrows so large are, that begin where the force acts.
Whisker whisker_of(const FrameParts& parts, const SnapshotForce& force) {
  const ForceScale& scale = parts.options.force_scale;
  const Vec2 direction = force.force.normalized();
  const auto tip = [&](double newton) {
    const double length = std::min(newton * scale.metres_per_newton, scale.longest);
    return parts.pixel(force.point + length * direction);
  };
  const bool goes_on = force.range->most * scale.metres_per_newton > scale.longest;
  return moved_beside(parts, direction, {tip(force.range->least), tip(force.range->most), goes_on});
}

}  // namespace

void add_whiskers(const FrameParts& parts) {
  std::vector<Whisker> whiskers;
  const auto add = [&](const auto& forces) {
    for (const auto& force : forces)
      if (force.range) whiskers.push_back(whisker_of(parts, force));
  };
  if (parts.has(Layer::contact_forces)) add(parts.snapshot.forces);
  if (parts.has(Layer::forces)) add(parts.snapshot.joints);
  paint(parts, whiskers);
}

void paint_whisker(const FrameParts& parts, Pixel from, Pixel to, bool goes_on) {
  WhiskerPen(parts, {from, to, goes_on}).paint(line_width, parts.style.whisker);
}

}  // namespace wuerfel::internal
