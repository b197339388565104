#include "app/film/specks.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/core.h>

namespace wuerfel {

namespace {

constexpr double speck = 4.0;      // px
constexpr double apart = 20.0;     // sides between the centres of neighbours of two groups
constexpr double margin = 4.0;     // sides around a group
constexpr double much_less = 0.5;  // of the view's width

std::vector<SnapshotBox> cubes_of(const Snapshot& snapshot) {
  std::vector<SnapshotBox> cubes;
  std::ranges::copy_if(snapshot.boxes, std::back_inserter(cubes),
                       [](const SnapshotBox& box) { return !box.fixed; });
  std::ranges::sort(cubes, {}, [](const SnapshotBox& box) { return box.center.x(); });
  return cubes;
}

double mean_side(const std::vector<SnapshotBox>& cubes) {
  double sum = 0.0;
  for (const SnapshotBox& box : cubes)
    sum += typical_side_of(box);
  return sum / static_cast<double>(cubes.size());
}

// The longest run of neighbours from left to right.
Bounds largest_group(const std::vector<SnapshotBox>& cubes, double side) {
  Bounds largest;
  std::ptrdiff_t most = 0;
  for (auto first = cubes.begin(); first != cubes.end();) {
    auto last = first;
    while (last + 1 != cubes.end() && (last + 1)->center.x() - last->center.x() < apart * side)
      ++last;
    if (last + 1 - first > most) {
      most = last + 1 - first;
      largest = {};
      for (auto box = first; box != last + 1; ++box)
        largest.include(*box);
    }
    first = last + 1;
  }
  return largest;
}

}  // namespace

std::string hint_at_specks(const Snapshot& snapshot, const View& view) {
  const std::vector<SnapshotBox> cubes = cubes_of(snapshot);
  if (cubes.empty()) return {};
  const double side = mean_side(cubes);
  const double pixels = side * view.pixels_per_metre;
  if (pixels >= speck) return {};
  const Bounds group = largest_group(cubes, side);
  const double shape = static_cast<double>(view.width) / view.height;
  const Vec2 size = group.size() + Vec2::Constant(margin * side);
  const double width = std::max(size.x(), size.y() * shape);
  if (width > much_less * view.width / view.pixels_per_metre) return {};
  const Vec2 middle = 0.5 * (group.min + group.max);
  return fmt::format(
      "the motion is so wide that a cube has {:.2g} pixels; --view {:.6g},{:.6g},{:.6g} shows the "
      "largest group",
      pixels, middle.x(), middle.y(), width);
}

}  // namespace wuerfel
