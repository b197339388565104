// Free bodies: all forces on each, with their numbers.
#include <algorithm>
#include <string>

#include "render/picture/explode.h"
#include "render/picture/labels.h"
#include "tests/unit/render/picture/composition.h"

namespace wuerfel::test {
namespace {

TEST_F(Composition, FreeBodiesShowBothForcesOfEachPair) {
  const Snapshot apart = exploded(snapshot, 0.5);
  ASSERT_EQ(apart.forces.size(), 9U + 6U) << "the floor is not cut free";
  EXPECT_EQ(apart.boxes[5].size, snapshot.boxes[5].size);
  const Vec2 foot =
      snapshot.boxes[5].center - 2.0 * (apart.boxes[5].center - snapshot.boxes[5].center);
  EXPECT_NEAR(foot.y(), 0.0, 0.2) << "spread about the foot";
  Vec2 sum = Vec2::Zero();
  for (const SnapshotForce& force : apart.forces)
    sum += force.force;
  EXPECT_NEAR(sum.y(), 50.0, 1e-12) << "what the floor bears";
  options.explode = 0.5;
  const DrawList list = compose({Layer::cubes, Layer::forces});
  EXPECT_EQ(arrows_of(list, style.contact).size(), 15U);
}

class FreeBodies : public Composition {
 protected:
  FreeBodies() { options.explode = 0.5; }
  int numbers(const DrawList& list, const std::string& text) const {
    return static_cast<int>(std::ranges::count(list.texts, text, &TextShape::text));
  }
};

TEST_F(FreeBodies, ForcesTooSmallForAnArrowHaveTheirNumbers) {
  snapshot.joints.front().force = Vec2(0.0, 0.123);
  const Layers layers{Layer::cubes, Layer::forces, Layer::weights, Layer::values};
  EXPECT_EQ(numbers(compose(layers), "123 mN"), 1) << "the other body is the floor";
  snapshot.boxes.front().mass = 0.0234 / snapshot.gravity.norm();
  EXPECT_EQ(numbers(compose(layers), "23.4 mN"), 1);
}

TEST_F(FreeBodies, NumbersKeepOffPins) {
  const SnapshotBox& box = snapshot.boxes.front();
  snapshot.joints.clear();
  snapshot.links = {{.name = "pin",
                     .pin = true,
                     .a = box.center,
                     .b = box.center,
                     .bodies = {box.name, ""},
                     .force = Vec2(-7.0, 0.0)}};
  const DrawList list = compose({Layer::cubes, Layer::forces, Layer::values});
  ASSERT_EQ(numbers(list, "7.00 N"), 1);
  const auto number = std::ranges::find(list.texts, "7.00 N", &TextShape::text);
  const internal::Area area = internal::text_area(*number, font);
  for (const DiscShape& pin : list.discs) {
    const auto x = static_cast<double>(pin.center.x);
    const auto y = static_cast<double>(pin.center.y);
    const double r = static_cast<double>(pin.radius) + 1.0;
    EXPECT_TRUE(y + r < area.top || y - r > area.bottom || x + r < area.left || x - r > area.right);
  }
}

}  // namespace
}  // namespace wuerfel::test
