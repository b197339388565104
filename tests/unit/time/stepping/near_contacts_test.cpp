// Who may meet whom within a step.
#include "core/time/stepping/near_contacts.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

TEST(NearContacts, PairsAreKeptApartByTheSidesThatFaceEachOther) {
  const Mechanism m(side_by_side(0.005));
  NearContacts near(m.system);
  near.begin(m.state, 0.01, 9.81);
  State end = m.state;
  end[0].position.x() += 0.008;
  std::vector<Contact> contacts = near.find_towards(end, 1e-2);
  ASSERT_EQ(contacts.size(), 2U);
  for (const Contact& c : contacts)
    EXPECT_NEAR(c.gap, 0.005, 1e-15);
  const std::vector<Box> boxes = near.end_boxes();
  contacts = near.find_at(boxes, 1e-2);
  ASSERT_EQ(contacts.size(), 2U);
  for (const Contact& c : contacts)
    EXPECT_NEAR(c.gap, -0.003, 1e-15);
}

TEST(NearContacts, WhoIsFarAwayMeetsNobody) {
  const Mechanism m(side_by_side(0.5));
  NearContacts near(m.system);
  near.begin(m.state, 0.01, 9.81);
  EXPECT_TRUE(near.find_towards(m.state, 1e-2).empty());
}

TEST(NearContacts, CornersThatComeNearAPlaneAreThere) {
  const Mechanism m(on_floor({cube("a", {0.0, 0.6}, 0.2)}));
  NearContacts near(m.system);
  near.begin(m.state, 0.01, 9.81);
  State end = m.state;
  EXPECT_TRUE(near.find_towards(end, 1e-2).empty());
  const double lowest =
      m.state[0].position.y() + make_box(Vec2::Zero(), 0.2, Vec2::Ones()).arm[0].y();
  end[0].position.y() -= lowest - 0.005;
  const std::vector<Contact> contacts = near.find_towards(end, 1e-2);
  ASSERT_EQ(contacts.size(), 1U) << "the other corner is 0.2 m higher";
  EXPECT_EQ(contacts[0].corner, 0);
  EXPECT_NEAR(contacts[0].gap, lowest, 1e-15) << "as at the beginning";
}

TEST(NearContacts, ASecondCornerIsThereOnlyWhereSidesMayBecomeFlush) {
  // b above a, tilted by 0.01: sides may become flush within the step where it turns, or where the fall is not small.
  Scene scene;
  scene.cubes = {cube("a", {0.0, 0.0}), cube("b", {0.0, 1.01}, 0.01)};
  Mechanism m(scene);
  NearContacts near(m.system);
  near.begin(m.state, 0.001, 9.81);
  EXPECT_EQ(near.find_towards(m.state, 2e-2).size(), 1U);
  m.state[1].spin = 6.0;
  near.begin(m.state, 0.001, 9.81);
  EXPECT_EQ(near.find_towards(m.state, 2e-2).size(), 2U);
}

}  // namespace
}  // namespace wuerfel::test
