#include "render/picture/force_scale.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace wuerfel {
namespace {

constexpr double longest_in_sides = 1.5;
constexpr double cut_in_sides = 2.5;
constexpr double cut_of_given_scale_in_sides = 6.0;
constexpr double ordinary_share = 0.99;  ///< of all arrows is drawn at full length
constexpr double hidden_share = 2e-3;    ///< of the largest ordinary force

}  // namespace

double round_down_125(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  // A hair of slack, so that 0.2 / 0.1 counts as 2.
  const double mantissa = value / decade * (1.0 + 1e-9);
  if (mantissa >= 10.0) return 10.0 * decade;
  if (mantissa >= 5.0) return 5.0 * decade;
  return mantissa >= 2.0 ? 2.0 * decade : decade;
}

void ForceRange::include(const Snapshot& snapshot) {
  for (const SnapshotForce& force : snapshot.forces) {
    const double magnitude = force.force.norm();
    if (!(magnitude > 0.0) || !std::isfinite(magnitude)) continue;
    largest_ = std::max(largest_, magnitude);
    const double bin = bins_per_octave * (std::log2(magnitude) + 0.5 * octaves);
    const double last = static_cast<double>(histogram_.size() - 1);
    ++histogram_.at(static_cast<std::size_t>(std::clamp(bin, 0.0, last)));
    ++count_;
  }
  // Sizes never change: the first snapshot tells them all.
  if (side_count_ > 0) return;
  for (const SnapshotBox& box : snapshot.boxes) {
    if (box.fixed) continue;
    side_sum_ += std::sqrt(box.size.x() * box.size.y());
    ++side_count_;
  }
}

double ForceRange::typical_side() const {
  return side_count_ == 0 ? 1.0 : side_sum_ / static_cast<double>(side_count_);
}

ForceScale ForceRange::scale() const {
  ForceScale scale;
  if (count_ == 0) return scale;
  const auto wanted =
      static_cast<std::uint64_t>(std::ceil(ordinary_share * static_cast<double>(count_)));
  std::size_t bin = 0;
  for (std::uint64_t seen = histogram_[0]; seen < wanted; seen += histogram_.at(bin))
    ++bin;
  const double upper_end =
      std::exp2((static_cast<double>(bin) + 1.0) / bins_per_octave - 0.5 * octaves);
  const double ordinary = std::min(upper_end, largest_);
  const bool peaks = largest_ * longest_in_sides > ordinary * cut_in_sides;
  const double full_length = peaks ? ordinary : largest_;
  scale.metres_per_newton = longest_in_sides * typical_side() / full_length;
  scale.longest = cut_in_sides * typical_side();
  scale.hidden_below = hidden_share * full_length;
  return scale;
}

ForceScale fixed_force_scale(double metres_per_newton, const ForceRange& range) {
  const double side = range.typical_side();
  ForceScale scale;
  scale.metres_per_newton = metres_per_newton;
  scale.longest = cut_of_given_scale_in_sides * side;
  scale.hidden_below = hidden_share * longest_in_sides * side / metres_per_newton;
  return scale;
}

}  // namespace wuerfel
