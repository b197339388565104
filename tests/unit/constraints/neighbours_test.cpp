// Neighbours and sets of bodies.
#include "core/constraints/neighbours.h"

#include <gtest/gtest.h>

#include "core/geometry/union_find.h"
#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

TEST(Neighbours, ArePairsWithACube) {
  Scene scene = on_floor({cube("a", {0.0, 0.5}), cube("b", {0.9, 1.4}), cube("c", {5.0, 0.5})});
  scene.fixed = {post("p", {5.5, 0.0}, {1.0, 1.0}), post("q", {6.0, 0.0}, {1.0, 1.0})};
  const Mechanism m(scene);
  std::vector<Box> boxes;
  pose_boxes(m.system, m.state, boxes);
  EXPECT_EQ(box_count(m.system), 5);
  Neighbours neighbours;
  const auto pairs = neighbours.find(m.system, [&](int i) { return posed_bounds(boxes[i], 0.1); });
  const std::vector<IndexPair> expected = {{0, 1}, {2, 3}, {2, 4}};
  EXPECT_EQ(std::vector<IndexPair>(pairs.begin(), pairs.end()), expected) << "p and q are fixed";
}

TEST(UnionFind, RootIsTheSmallestOfTheSet) {
  UnionFind sets(6);
  EXPECT_TRUE(sets.unite(4, 2));
  EXPECT_TRUE(sets.unite(5, 4));
  EXPECT_FALSE(sets.unite(2, 5));
  EXPECT_TRUE(sets.unite(1, 5));
  for (const int i : {1, 2, 4, 5})
    EXPECT_EQ(sets.root(i), 1);
  EXPECT_EQ(sets.root(0), 0);
  EXPECT_EQ(sets.root(3), 3);
}

}  // namespace
}  // namespace wuerfel::test
