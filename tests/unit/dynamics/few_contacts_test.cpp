// Few contacts are solved by a short cut: it must say what the program says.
#include "core/dynamics/few_contacts.h"

#include <gtest/gtest.h>

#include "core/dynamics/programs.h"
#include "core/qp/equality_solver.h"
#include "tests/support/random_motion.h"

namespace wuerfel::test {
namespace {

SceneCube cube(const std::string& name, const Vec2& position, double mass) {
  SceneCube c;
  c.name = name;
  c.position = position;
  c.mass = mass;
  return c;
}

/// A cube flush on another one on the floor: four contacts of three kinds.
struct Stack {
  System system;
  State state;
  Island island;
};

Stack make_stack() {
  Scene scene;
  scene.planes.push_back({"floor", Vec2::Zero(), Vec2::UnitY(), {}});
  scene.cubes = {cube("low", {0.0, 0.5}, 2.0), cube("high", {0.3, 1.5}, 1.0)};
  Stack stack{make_system(scene), initial_state(scene), {}};
  RandomNumbers random(3);
  for (BodyState& s : stack.state) {
    s.velocity = random.next_vec2();
    s.spin = random.next();
  }
  ContactFinder finder;
  std::vector<Contact> contacts;
  finder.find(stack.system, stack.state, contacts);
  std::vector<Island> islands;
  find_islands(stack.system, contacts, islands);
  stack.island = islands.at(0);
  for (Contact& c : stack.island.contacts)
    c.gap = 1e-3 * random.next();
  return stack;
}

TEST(FewContacts, SayWhatTheProgramSays) {
  const Stack stack = make_stack();
  ASSERT_EQ(stack.island.contacts.size(), 4U);
  const std::vector<SideUse> use(stack.island.contacts.size(), SideUse::equality);
  ProgramBuilder builder(stack.system, Formulation::rigid);
  EqualitySolver solver;
  FewContacts few;
  for (const Order order : {Order::acceleration, Order::velocity, Order::position}) {
    if (order == Order::acceleration) builder.acceleration(stack.state, stack.island, use);
    if (order == Order::velocity) builder.velocity(stack.state, stack.island, use);
    if (order == Order::position) builder.position(stack.state, stack.island, use);
    std::vector<double> x, forces, few_x, few_forces;
    solver.factorise(builder.program());
    solver.solve(builder.program(), x, forces);
    few.build(stack.system, stack.state, stack.island, order);
    ASSERT_TRUE(few.solve(few_x, few_forces));
    ASSERT_EQ(few_x.size(), x.size());
    ASSERT_EQ(few_forces.size(), forces.size());
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_NEAR(few_x[i], x[i], 1e-12);
    for (std::size_t i = 0; i < forces.size(); ++i)
      EXPECT_NEAR(few_forces[i], forces[i], 1e-12);
  }
}

TEST(FewContacts, GiveUpWhereRowsDependOnOneAnother) {
  Stack stack = make_stack();
  stack.island.contacts.push_back(stack.island.contacts.front());
  FewContacts few;
  few.build(stack.system, stack.state, stack.island, Order::velocity);
  std::vector<double> x, forces;
  EXPECT_FALSE(few.solve(x, forces));
}

}  // namespace
}  // namespace wuerfel::test
