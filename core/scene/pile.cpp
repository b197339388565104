#include "core/scene/pile.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "core/geometry/bounds.h"
#include "core/geometry/box.h"
#include "core/scene/counter_random.h"
#include "core/scene/groups.h"

namespace wuerfel {
namespace {

/// Poses a cube was tried in before the region counts as full.
constexpr int pile_tries = 2'000;

struct PilePose {
  Vec2 position = Vec2::Zero();  ///< m
  double angle = 0.0;            ///< rad, in [0, pi)
};

/// Boxes by the cells of a grid over the region that their bounds meet. A cell is no smaller than
/// `least_cell`, so that a cube meets few of them.
class Grid {
 public:
  Grid(const Region& region, double least_cell, std::int64_t expected)
      : region_{region.low, region.high} {
    const Vec2 extent = region.high - region.low;
    const double most = 2.0 * std::sqrt(static_cast<double>(expected)) + 1.0;
    for (int axis = 0; axis < 2; ++axis) {
      const double cells = std::clamp(std::floor(extent[axis] / least_cell), 1.0, std::floor(most));
      count_[axis] = static_cast<int>(cells);
      cell_[axis] = extent[axis] / cells;
    }
    cells_.resize(count_[0] * count_[1]);
  }

  void add(const Box& box, double margin) {
    if (!posed_bounds(box, margin).overlaps(region_)) return;
    const int index = static_cast<int>(boxes_.size());
    boxes_.push_back(box);
    visit(box, margin, [&](std::vector<int>& cell) {
      cell.push_back(index);
      return true;
    });
  }

  /// Whether no box is nearer to `box` than `clearance`.
  bool is_clear(const Box& box, double clearance) {
    return visit(box, 0.0, [&](const std::vector<int>& cell) {
      return std::none_of(cell.begin(), cell.end(),
                          [&](int i) { return separation(box, boxes_[i]) < clearance; });
    });
  }

 private:
  [[nodiscard]] int cell_of(double place, int axis) const {
    const double cell = std::floor((place - region_.low[axis]) / cell_[axis]);
    return static_cast<int>(std::clamp(cell, 0.0, count_[axis] - 1.0));
  }

  /// Calls `action` for the cells that the bounds of `box`, widened by `margin`, meet, until it
  /// says no.
  template <class Action>
  bool visit(const Box& box, double margin, const Action& action) {
    const auto [low, high] = posed_bounds(box, margin);
    const int last_column = cell_of(high.x(), 0);
    const int last_row = cell_of(high.y(), 1);
    for (int row = cell_of(low.y(), 1); row <= last_row; ++row) {
      for (int column = cell_of(low.x(), 0); column <= last_column; ++column) {
        const int cell = row * count_[0] + column;
        if (!action(cells_[cell])) return false;
      }
    }
    return true;
  }

  BoundingBox region_;
  Vec2 cell_ = Vec2::Ones();  ///< m
  std::array<int, 2> count_{1, 1};
  std::vector<std::vector<int>> cells_;
  std::vector<Box> boxes_;
};

/// The pose number `number` of the pile's sequence; nothing where the cube does not fit into the
/// region at its angle.
std::optional<PilePose> random_pose(const PileEntry& pile, std::uint64_t number) {
  const auto seed = static_cast<std::uint64_t>(pile.seed);
  PilePose pose;
  pose.angle = std::numbers::pi * random_unit(seed, 3 * number);
  const Vec2 half = make_box(pose.position, pose.angle, pile.size.extent).extent();
  const Vec2 low = pile.region.low + half;
  const Vec2 room = pile.region.high - half - low;
  if (room.minCoeff() < 0.0) return std::nullopt;
  pose.position = {low.x() + room.x() * random_unit(seed, 3 * number + 1),
                   low.y() + room.y() * random_unit(seed, 3 * number + 2)};
  return pose;
}

/// Poses for the cubes of `pile`, each within the region and at least a hundredth of the smaller
/// side away from the others, the obstacles and the planes (random sequential addition: about half
/// the area can be filled). Fewer than pile.count where a cube found no place in pile_tries tries.
std::vector<PilePose> scatter(const PileEntry& pile,
                              const std::vector<Box>& obstacles,
                              const std::vector<ScenePlane>& planes) {
  const double clearance = 0.01 * pile.size.extent.minCoeff();
  Grid grid(pile.region, pile.size.extent.norm(), pile.count);
  for (const Box& obstacle : obstacles) {
    grid.add(obstacle, clearance);
  }
  const auto is_free = [&](const Box& box) {
    const bool clear_of_planes =
        std::all_of(planes.begin(), planes.end(), [&](const ScenePlane& plane) {
          return plane_separation(plane.point, plane.normal, box) >= clearance;
        });
    return clear_of_planes && grid.is_clear(box, clearance);
  };
  std::vector<PilePose> poses;
  std::uint64_t number = 0;
  for (int tries = 0; static_cast<std::int64_t>(poses.size()) < pile.count && tries < pile_tries;
       ++tries) {
    const std::optional<PilePose> pose = random_pose(pile, number++);
    if (!pose) continue;
    const Box box = make_box(pose->position, pose->angle, pile.size.extent);
    if (!is_free(box)) continue;
    grid.add(box, clearance);
    poses.push_back(*pose);
    tries = 0;
  }
  return poses;
}

}  // namespace

void scatter_piles(Scene& scene, const std::vector<PileEntry>& piles, const SceneSource& source) {
  if (piles.empty()) return;
  std::int64_t scattered = 0;
  for (const PileEntry& pile : piles) {
    scattered += pile.count;
  }
  std::vector<Box> obstacles;
  for (const SceneFixed& fixed : scene.fixed) {
    obstacles.push_back(make_box(fixed.position, fixed.angle, fixed.size));
  }
  for (const ScenePoint& point : scene.points) {
    obstacles.push_back(make_box(point.position, 0.0, Vec2::Zero()));
  }
  auto next = scene.cubes.end() - scattered;
  for (auto cube = scene.cubes.begin(); cube != next; ++cube) {
    obstacles.push_back(make_box(cube->position, cube->angle, cube->size));
  }
  for (const PileEntry& pile : piles) {
    const std::vector<PilePose> poses = scatter(pile, obstacles, scene.planes);
    if (static_cast<std::int64_t>(poses.size()) < pile.count) {
      source.fail(place_of(pile.origin, "region"), pile.origin.path,
                  fmt::format("only {} of {} cubes found a place clear of all others; enlarge the "
                              "region or ask for fewer",
                              poses.size(), pile.count));
    }
    for (const PilePose& pose : poses) {
      next->position = pose.position;
      next->angle = pose.angle;
      obstacles.push_back(make_box(next->position, next->angle, next->size));
      ++next;
    }
  }
}

}  // namespace wuerfel
