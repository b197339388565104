#include "core/scene/layout.h"

namespace wuerfel {
namespace {

/// Appends `count` full cubes side by side; the left edge of the first is at `left`, in steps of
/// one size. Places are products, not sums, so that errors do not grow along the row.
void append_row(
    std::vector<Brick>& bricks, std::int64_t count, double left, double level, const Vec2& size) {
  for (std::int64_t i = 0; i < count; ++i) {
    const Vec2 center((left + 0.5 + static_cast<double>(i)) * size.x(), (level + 0.5) * size.y());
    bricks.push_back({center, size, 1.0});
  }
}

}  // namespace

std::vector<Brick> tower_layout(const TowerEntry& tower) {
  std::vector<Brick> bricks;
  const Vec2& size = tower.size.extent;
  for (std::int64_t i = 0; i < tower.count; ++i) {
    const auto level = static_cast<double>(i);
    bricks.push_back({{level * tower.lean, (level + 0.5) * size.y()}, size, 1.0});
  }
  return bricks;
}

std::vector<Brick> wall_layout(const WallEntry& wall) {
  std::vector<Brick> bricks;
  const Vec2& size = wall.size.extent;
  const double half_width = 0.5 * static_cast<double>(wall.columns);  // in sizes
  for (std::int64_t row = 0; row < wall.rows; ++row) {
    const auto level = static_cast<double>(row);
    if (wall.bond == Bond::stack || row % 2 == 0) {
      append_row(bricks, wall.columns, -half_width, level, size);
      continue;
    }
    const Vec2 half(0.5 * size.x(), size.y());
    const Vec2 end((half_width - 0.25) * size.x(), (level + 0.5) * size.y());
    bricks.push_back({{-end.x(), end.y()}, half, 0.5});
    append_row(bricks, wall.columns - 1, 0.5 - half_width, level, size);
    bricks.push_back({end, half, 0.5});
  }
  return bricks;
}

std::vector<Brick> pyramid_layout(const PyramidEntry& pyramid) {
  std::vector<Brick> bricks;
  for (std::int64_t row = 0; row < pyramid.rows; ++row) {
    const std::int64_t count = pyramid.rows - row;
    append_row(bricks, count, -0.5 * static_cast<double>(count), static_cast<double>(row),
               pyramid.size.extent);
  }
  return bricks;
}

}  // namespace wuerfel
