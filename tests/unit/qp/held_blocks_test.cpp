// Programs with several solutions: what stands stays where it can.
#include "core/qp/coulomb/held_blocks.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/geometry/vec2.h"

namespace wuerfel::test {
namespace {

constexpr double weight = 9.81;  // per kg
constexpr std::array<double, 3> falls{0.0, -weight, 0.0};
constexpr std::array<double, 3> masses{2.0, 2.0, 1.0};

/// A row n' v >= 0 and its tangent on one block, or between two.
void add_contact(FrictionContact contact,
                 std::initializer_list<std::pair<int, Vec2>> normals,
                 QuadraticProgram& program,
                 std::vector<FrictionContact>& contacts) {
  contact.normal = program.add_inequality(0.0);
  for (const auto& [block, n] : normals)
    program.add_entry(block, std::array{n.x(), n.y(), 0.0});
  contact.tangent = program.add_row(0.0, -unbounded, unbounded);
  for (const auto& [block, n] : normals)
    program.add_entry(block, std::array{-n.y(), n.x(), 0.0});
  contacts.push_back(contact);
}

/// A block in a shaft, which may fall or be held by its walls, and one that falls beside it, or on it.
struct Shaft {
  explicit Shaft(double mu, bool on_it) {
    program.add_block(masses, falls);
    program.add_block(masses, falls);
    for (const double side : {1.0, -1.0})
      add_contact({-1, -1, mu, 0}, {{0, Vec2(side, 0.0)}}, program, contacts);
    if (on_it)
      add_contact({-1, -1, 0.1, 1}, {{1, Vec2::UnitY()}, {0, -Vec2::UnitY()}}, program, contacts);
  }
  [[nodiscard]] FrictionProgram friction() const { return {program, contacts}; }

  QuadraticProgram program;
  std::vector<FrictionContact> contacts;
};

TEST(HeldBlocks, WhatMayFallOrStandStands) {
  const Shaft shaft(0.5, false);
  CoulombResult result;
  result.status = QpStatus::optimal;
  result.x = {0.0, -weight, 0.0, 0.0, -weight, 0.0};
  result.multiplier.assign(4, 0.0);
  EXPECT_LE(coulomb_residual(shaft.friction(), result.x, result.multiplier).worst(), 1e-14)
      << "a fall of both is a solution";
  let_stand(shaft.friction(), std::array<char, 2>{1, 0}, result);
  EXPECT_EQ(result.status, QpStatus::optimal);
  EXPECT_NEAR(result.x[1], 0.0, 1e-12);
  EXPECT_NEAR(result.x[4], -weight, 1e-12);
  EXPECT_NEAR(result.multiplier[1] - result.multiplier[3], 2.0 * weight, 1e-9);
  EXPECT_LE(coulomb_residual(shaft.friction(), result.x, result.multiplier).worst(), 1e-10);
}

TEST(HeldBlocks, ThoseThatMoveWeighOnThoseThatStand) {
  const Shaft shaft(0.5, true);
  const std::optional<CoulombResult> held =
      solve_holding(shaft.friction(), std::array<char, 2>{1, 0});
  ASSERT_TRUE(held);
  EXPECT_NEAR(held->x[1], 0.0, 1e-12);
  EXPECT_NEAR(held->x[4], 0.0, 1e-12) << "it lies on the other";
  EXPECT_NEAR(std::abs(held->x[3]), 0.1 * weight, 1e-10) << "and is braked";
  EXPECT_NEAR(held->multiplier[1] - held->multiplier[3], 4.0 * weight, 1e-9);
}

TEST(HeldBlocks, WhatCannotStandIsLeftAsItIs) {
  const Shaft shaft(0.0, false);
  EXPECT_FALSE(solve_holding(shaft.friction(), std::array<char, 2>{1, 0}));
  CoulombResult result;
  CoulombSolver().solve(shaft.friction(), result);
  let_stand(shaft.friction(), std::array<char, 2>{1, 0}, result);
  EXPECT_NEAR(result.x[1], -weight, 1e-12);
}

TEST(HeldBlocks, NothingIsDoneWhereAllOrNoneStand) {
  const Shaft shaft(0.5, false);
  CoulombResult result;
  result.status = QpStatus::optimal;
  result.x = {0.0, -weight, 0.0, 0.0, -weight, 0.0};
  for (const char mark : {char{0}, char{1}}) {
    let_stand(shaft.friction(), std::array<char, 2>{mark, mark}, result);
    EXPECT_EQ(result.x[1], -weight);
  }
}

}  // namespace
}  // namespace wuerfel::test
