// A grid time: who rests, and what presses.
#include "core/time/reference/grid_point.h"

#include <gtest/gtest.h>

namespace wuerfel::test {
namespace {

Island pair_of_cubes() {
  Island island;
  island.cubes = {1, 2};
  island.contacts.resize(3);
  for (int k = 0; k < 3; ++k)
    island.contacts[k].corner = k;
  return island;
}

TEST(GridPoint, RestsWhereAllOfItDoes) {
  EXPECT_TRUE(all_rest(pair_of_cubes(), {0, 1, 1}));
  EXPECT_FALSE(all_rest(pair_of_cubes(), {1, 1, 0}));
  GridPoint point;
  point.resting = {0, 1, 1};
  EXPECT_FALSE(point.at_rest());
  point.resting = {1, 1, 1};
  EXPECT_TRUE(point.at_rest());
}

TEST(GridPoint, PressedIsWhatSolversDoNotLeaveByThemselves) {
  IslandSolution solution;
  solution.forces = {10.0, 0.5e-8, 2e-8};
  std::vector<Contact> pressed;
  add_pressed(pair_of_cubes(), solution, pressed);
  ASSERT_EQ(pressed.size(), 2U) << "1e-9 of the largest force";
  EXPECT_EQ(pressed[0].corner, 0);
  EXPECT_EQ(pressed[1].corner, 2);
}

}  // namespace
}  // namespace wuerfel::test
