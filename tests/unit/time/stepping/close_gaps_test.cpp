// The closing of gaps when stepping ends.
#include "core/time/stepping/close_gaps.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace wuerfel::test {
namespace {

TEST(CloseGaps, ClosesThoseThatCarriedLoad) {
  const Mechanism m(on_floor({cube("a", {0.0, 0.5 + 1e-6}), cube("b", {3.0, 0.5 + 1e-6})}));
  ContactFinder finder;
  std::vector<Contact> contacts = finder.find(m.system, m.state, 1e-5);
  std::erase_if(contacts, [](const Contact& c) { return c.on == 1; });
  ClosedContacts closed(m.system);
  State state = m.state;
  close_gaps(contacts, closed, finder, state);
  EXPECT_NEAR(state[0].position.y(), 0.5, 1e-15);
  EXPECT_EQ(state[1].position.y(), 0.5 + 1e-6);
}

TEST(CloseGaps, LeavesWhatCannotBeClosed) {
  //   ###+---+ ###    the posts stand 2e-6 m farther apart than the block is wide
  //   ###| a | ###
  Scene scene;
  scene.fixed = {post("left", {-1.0 - 1e-6, 0.0}, {1.0, 3.0}),
                 post("right", {1.0 + 1e-6, 0.0}, {1.0, 3.0})};
  scene.cubes = {cube("a", {0.0, 0.0})};
  const Mechanism m(scene);
  ContactFinder finder;
  const std::vector<Contact> contacts = finder.find(m.system, m.state, 1e-5);
  ASSERT_EQ(contacts.size(), 4U);
  ClosedContacts closed(m.system);
  State state = m.state;
  close_gaps(contacts, closed, finder, state);
  EXPECT_EQ(state[0].position, m.state[0].position);
}

}  // namespace
}  // namespace wuerfel::test
