// Which cubes belong to one group for a while.
//
//   a   b ->      c        a and b meet within a second, c meets nobody
//  ------------------
#include "core/time/meetings.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

class MeetingsOfThree : public ::testing::Test {
 protected:
  MeetingsOfThree() {
    Scene scene = on_floor({cube("a", {0.0, 0.5}), cube("b", {2.5, 0.5}), cube("c", {9.0, 0.5})});
    scene.gravity = Vec2::Zero();
    scene.cubes[1].velocity = {-2.0, 0.0};
    system = make_system(scene);
    state = initial_state(scene);
  }

  System system;
  State state;
  std::vector<char> nobody_rests{0, 0, 0};
};

TEST_F(MeetingsOfThree, AreApartAtOneInstant) {
  EXPECT_EQ(Meetings(system, true).within(state, nobody_rests, 0.0), (Parts{{0}, {1}, {2}}));
}

TEST_F(MeetingsOfThree, ThoseThatMeetWithinAWhileAreOneGroup) {
  EXPECT_EQ(Meetings(system, true).within(state, nobody_rests, 1.0), (Parts{{0, 1}, {2}}));
}

TEST_F(MeetingsOfThree, WhatRestsStaysWhereItIs) {
  EXPECT_EQ(Meetings(system, true).within(state, {1, 1, 1}, 1.0), (Parts{{0}, {1}, {2}}));
}

TEST_F(MeetingsOfThree, AreAllOneGroupWhereThatIsAsked) {
  EXPECT_EQ(Meetings(system, false).within(state, nobody_rests, 0.0), (Parts{{0, 1, 2}}));
}

TEST_F(MeetingsOfThree, RodsJoinWhatIsFarApart) {
  Rod rod;
  rod.i.body = 0;
  rod.j.body = 2;
  system.rods.push_back(rod);
  EXPECT_EQ(Meetings(system, true).within(state, nobody_rests, 0.0), (Parts{{0, 2}, {1}}));
}

TEST_F(MeetingsOfThree, GroupsWhoseSweepsOverlapAreJoined) {
  const std::vector<BoundingBox> swept{{{0, 0}, {1, 1}}, {{5, 0}, {6, 1}}, {{0.5, 0}, {2, 1}}};
  Meetings meetings(system, true);
  EXPECT_EQ(meetings.joined(swept, {0, 1, 2}, 3), (Parts{{0, 2}, {1}}));
  EXPECT_EQ(meetings.joined(swept, {0, 1, 0}, 2), Parts{}) << "they were one before";
}

}  // namespace
}  // namespace wuerfel::test
