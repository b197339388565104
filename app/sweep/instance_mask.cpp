#include "app/sweep/instance_mask.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/geometry/trig.h"

namespace wuerfel {

namespace {

/// A box as the pixels see it.
struct Footprint {
  Vec2 center;
  Vec2 half;
  double sine = 0.0;
  double cosine = 1.0;

  explicit Footprint(const SnapshotBox& box) : center(box.center), half(0.5 * box.size) {
    sin_cos(box.angle, sine, cosine);
  }

  [[nodiscard]] bool holds(const Vec2& world) const {
    const Vec2 d = world - center;
    return std::abs(d.x() * cosine + d.y() * sine) <= half.x()
           && std::abs(d.y() * cosine - d.x() * sine) <= half.y();
  }
};

/// Pixels whose middles lie between two places, kept inside of the picture.
struct Range {
  int begin;
  int end;
};

Range pixels_between(double low, double high, int size) {
  const auto pixel = [size](double place) {
    return static_cast<int>(std::clamp(std::floor(place), 0.0, static_cast<double>(size)));
  };
  return {pixel(low), std::min(pixel(high) + 1, size)};
}

void fill(const Footprint& box, const View& view, std::uint16_t number, NumberImage& mask) {
  const Vec2 middle = view.to_pixel(box.center);
  const double radius = box.half.norm() * view.pixels_per_metre;
  const Range rows = pixels_between(middle.y() - radius, middle.y() + radius, mask.height);
  const Range columns = pixels_between(middle.x() - radius, middle.x() + radius, mask.width);
  for (int y = rows.begin; y < rows.end; ++y) {
    for (int x = columns.begin; x < columns.end; ++x) {
      if (box.holds(view.to_world({x + 0.5, y + 0.5}))) mask.values[y * mask.width + x] = number;
    }
  }
}

}  // namespace

NumberImage number_mask(const Snapshot& snapshot,
                        const View& view,
                        std::span<const std::uint16_t> numbers) {
  NumberImage mask{view.width, view.height, {}};
  mask.values.assign(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height),
                     0);
  auto number = numbers.begin();
  for (const SnapshotBox& box : snapshot.boxes) {
    if (!box.fixed) fill(Footprint(box), view, *number++, mask);
  }
  return mask;
}

NumberImage instance_mask(const Snapshot& snapshot, const View& view) {
  std::vector<std::uint16_t> numbers(snapshot.boxes.size());
  std::iota(numbers.begin(), numbers.end(), std::uint16_t{1});
  return number_mask(snapshot, view, numbers);
}

}  // namespace wuerfel
