#include "core/geometry/broad_phase.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/random_motion.h"

namespace wuerfel::test {
namespace {

/// The oracle: every pair looked at.
std::vector<IndexPair> overlapping_pairs_brute_force(const std::vector<BoundingBox>& bounds) {
  std::vector<IndexPair> pairs;
  for (int i = 0; i < std::ssize(bounds); ++i) {
    for (int j = i + 1; j < std::ssize(bounds); ++j) {
      if (bounds[i].overlaps(bounds[j])) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

std::vector<BoundingBox> random_bounds(std::uint64_t seed, int n, double size_ratio) {
  RandomNumbers random(seed);
  std::vector<BoundingBox> bounds;
  for (int i = 0; i < n; ++i) {
    const Vec2 center = 10.0 * random.next_vec2();
    const double half = 0.3 * std::pow(size_ratio, random.next());
    bounds.push_back({center - Vec2(half, half), center + Vec2(half, half)});
  }
  return bounds;
}

TEST(BroadPhase, FindsWhatBruteForceFinds) {
  BroadPhase broad_phase;
  for (const int n : {0, 1, 2, 5, 17, 300}) {
    for (const double ratio : {1.0, 30.0}) {
      const std::vector<BoundingBox> bounds =
          random_bounds(static_cast<std::uint64_t>(n), n, ratio);
      EXPECT_EQ(broad_phase.overlapping_pairs(bounds), overlapping_pairs_brute_force(bounds)) << n;
    }
  }
}

TEST(BroadPhase, FindsTouchingCellsOfAGridAndStacksAllTheSame) {
  std::vector<BoundingBox> grid;
  std::vector<BoundingBox> stack;
  std::vector<BoundingBox> same;
  for (int i = 0; i < 100; ++i) {
    const Vec2 low(i % 10, i / 10);
    grid.push_back({low, low + Vec2::Ones()});
    stack.push_back({Vec2(0, i), Vec2(1, i + 1)});
    same.push_back({Vec2::Zero(), Vec2::Ones()});
  }
  BroadPhase broad_phase;
  EXPECT_EQ(broad_phase.overlapping_pairs(grid), overlapping_pairs_brute_force(grid));
  EXPECT_EQ(broad_phase.overlapping_pairs(stack).size(), 99U);
  EXPECT_EQ(broad_phase.overlapping_pairs(same).size(), 4950U);
}

TEST(BroadPhase, FindsTheSamePairsWhileBoundsMoveOnAndJump) {
  // Small movements are answered from remembered pairs, large ones are not.
  BroadPhase broad_phase;
  RandomNumbers random(7);
  std::vector<BoundingBox> bounds = random_bounds(11, 200, 3.0);
  for (int step = 0; step < 200; ++step) {
    const double reach = step % 20 == 19 ? 1.0 : 0.004;
    for (BoundingBox& b : bounds) {
      const Vec2 move = reach * random.next_vec2();
      b = {b.low + move, b.high + move};
    }
    EXPECT_EQ(broad_phase.overlapping_pairs(bounds), overlapping_pairs_brute_force(bounds)) << step;
  }
  bounds.pop_back();
  EXPECT_EQ(broad_phase.overlapping_pairs(bounds), overlapping_pairs_brute_force(bounds));
}

}  // namespace
}  // namespace wuerfel::test
