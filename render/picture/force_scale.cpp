#include "render/picture/force_scale.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "render/picture/view.h"

namespace wuerfel {
namespace {

constexpr double longest_in_sides = 0.8;
constexpr double least_weight_in_sides = 0.15;
constexpr double largest_weight_in_sides = 0.5;
constexpr double cut_of_given_scale_in_sides = 6.0;
constexpr double ordinary_share = 0.95;  ///< of all forces is drawn at full length
constexpr double hidden_length_in_sides = 0.01;
constexpr double share_of_pusher = 0.8;  ///< that an arrow may cross

/// How far a ray from a place on a box runs through it, m.
double depth_along(const SnapshotBox& box, const Vec2& from, const Vec2& direction) {
  const Vec2 along = axis_of(box);
  double depth = std::numeric_limits<double>::max();
  for (const auto& [axis, half] :
       {std::pair(along, 0.5 * box.size.x()), std::pair(Vec2(perp(along)), 0.5 * box.size.y())}) {
    const double place = (from - box.center).dot(axis);
    const double rate = direction.dot(axis);
    if (rate != 0.0)
      depth = std::min(depth, (half - std::copysign(place, place * rate)) / std::abs(rate));
  }
  return std::max(depth, 0.0);
}

/// The median of m g over the cubes, over the point masses where there is no cube; 0 without gravity.
double median_weight(const Snapshot& snapshot) {
  std::vector<double> masses;
  for (const SnapshotBox& box : snapshot.boxes)
    if (!box.fixed) masses.push_back(box.mass);
  if (masses.empty()) {
    for (const SnapshotMass& mass : snapshot.masses)
      masses.push_back(mass.mass);
  }
  if (masses.empty()) return 0.0;
  const auto middle = masses.begin() + static_cast<std::ptrdiff_t>(masses.size() / 2);
  std::ranges::nth_element(masses, middle);
  return *middle * snapshot.gravity.norm();
}

}  // namespace

double round_down_125(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  // A hair of slack, so that 0.2 / 0.1 counts as 2.
  const double mantissa = value / decade * (1.0 + 1e-9);
  if (mantissa >= 10.0) return 10.0 * decade;
  if (mantissa >= 5.0) return 5.0 * decade;
  return mantissa >= 2.0 ? 2.0 * decade : decade;
}

double typical_side_of(const SnapshotBox& box) {
  constexpr double of_longer = 0.25;
  return std::max(std::sqrt(box.size.x() * box.size.y()), of_longer * box.size.maxCoeff());
}

JointArrow joint_arrow(const Snapshot& snapshot,
                       const SnapshotJoint& joint,
                       const ForceScale& scale) {
  const double magnitude = joint.force.norm();
  if (!(magnitude > 0.0)) return {joint.point, joint.point};
  const double full = scale.metres_per_newton * magnitude;
  const Vec2 direction = joint.force / magnitude;
  double length = std::min(full, scale.longest);
  if (joint.other >= 0 && joint.other < std::ssize(snapshot.boxes)) {
    length =
        std::min(length, share_of_pusher
                             * depth_along(snapshot.boxes[joint.other], joint.point, -direction));
  }
  return {joint.point - length * direction, joint.point, length < full * (1.0 - 1e-6)};
}

void ForceRange::include(double magnitude) {
  if (!(magnitude > 0.0) || !std::isfinite(magnitude)) return;
  largest_ = std::max(largest_, magnitude);
  smallest_ = count_ == 0 ? magnitude : std::min(smallest_, magnitude);
  const double bin = bins_per_octave * (std::log2(magnitude) + 0.5 * octaves);
  const double last = static_cast<double>(histogram_.size() - 1);
  ++histogram_.at(static_cast<std::size_t>(std::clamp(bin, 0.0, last)));
  ++count_;
}

void ForceRange::include(const Snapshot& snapshot) {
  for (const SnapshotForce& force : snapshot.forces)
    include(force.force.norm());
  for (const SnapshotJoint& joint : snapshot.joints) {
    include(joint.force.norm());
    // An endless arrow ends where the room for it does.
    const double room = joint_arrow(snapshot, joint, {.metres_per_newton = 1e300}).length();
    if (room > 0.0) steepest_ = std::max(steepest_, joint.force.norm() / room);
  }
  // Sizes and masses never change: the first snapshot tells them all.
  if (side_count_ > 0) return;
  weight_ = median_weight(snapshot);
  for (const SnapshotBox& box : snapshot.boxes) {
    if (box.fixed) continue;
    side_sum_ += typical_side_of(box);
    ++side_count_;
  }
}

double ForceRange::typical_side() const {
  return side_count_ == 0 ? 1.0 : side_sum_ / static_cast<double>(side_count_);
}

bool ForceRange::cuts(const ForceScale& scale) const {
  return scale.cuts(largest_) || scale.metres_per_newton * steepest_ > 1.0 + 1e-6;
}

double ForceRange::ordinary() const {
  const auto wanted =
      static_cast<std::uint64_t>(std::ceil(ordinary_share * static_cast<double>(count_)));
  std::size_t bin = 0;
  for (std::uint64_t seen = histogram_[0]; seen < wanted; seen += histogram_.at(bin))
    ++bin;
  const double upper_end =
      std::exp2((static_cast<double>(bin) + 1.0) / bins_per_octave - 0.5 * octaves);
  return std::min(upper_end, largest_);
}

ForceScale ForceRange::scale() const {
  ForceScale scale;
  const double side = typical_side();
  double full = weight_ / largest_weight_in_sides;  // N, of one side
  if (count_ > 0) {
    full = std::max(full, ordinary() / longest_in_sides);
    if (weight_ > 0.0) full = std::min(full, weight_ / least_weight_in_sides);
  }
  if (!(full > 0.0)) return scale;
  scale.metres_per_newton = side / full;
  scale.longest = longest_in_sides * side;
  scale.hidden_below = hidden_length_in_sides * full;
  return scale;
}

ForceScale fixed_force_scale(double metres_per_newton, const ForceRange& range) {
  const double side = range.typical_side();
  ForceScale scale;
  scale.metres_per_newton = metres_per_newton;
  scale.longest = cut_of_given_scale_in_sides * side;
  scale.hidden_below = hidden_length_in_sides * side / metres_per_newton;
  return scale;
}

}  // namespace wuerfel
