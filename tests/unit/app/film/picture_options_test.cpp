#include "app/film/picture_options.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "tests/support/image_scenes.h"

namespace wuerfel::test {
namespace {

PictureOptions fitted(Layers layers, const MotionRange& range) {
  PictureOptions options;
  options.layers = layers;
  options.size = {1280, 720};
  options.camera = parse_camera("0,2,10");
  return fit_scales(options, range);
}

MotionRange range_of(const Snapshot& snapshot) {
  MotionRange range;
  range.include(snapshot);
  return range;
}

TEST(LegendOf, NamesWhatOccursAndNothingElse) {
  Snapshot snapshot = test::pyramid_snapshot();
  for (SnapshotJoint& joint : snapshot.joints)
    joint.unique = true;
  std::erase_if(snapshot.forces,
                [](const SnapshotForce& f) { return f.kind == ForceKind::friction; });
  snapshot.impacts.clear();
  const Layers layers{Layer::cubes, Layer::contact_forces};
  const auto legend = [&] {
    return legend_of(fitted(layers, range_of(snapshot)), range_of(snapshot));
  };
  EXPECT_FALSE(legend().has(LegendEntry::friction)) << "no scene's promise, but what is drawn";
  EXPECT_FALSE(legend().has(LegendEntry::several));
  EXPECT_FALSE(legend().has(LegendEntry::impact));
  snapshot.forces.push_back({Vec2::Zero(), Vec2::UnitX(), ForceKind::friction, 0});
  snapshot.joints[0].unique = false;
  snapshot.impacts.push_back({Vec2::Zero(), 1.0, 0.0});
  EXPECT_TRUE(legend().has(LegendEntry::friction));
  EXPECT_TRUE(legend().has(LegendEntry::several));
  EXPECT_TRUE(legend().has(LegendEntry::impact));
}

TEST(LegendOf, NamesNoImpactThatIsTooWeakForARingOrHasFaded) {
  Snapshot snapshot = test::pyramid_snapshot();
  const auto named = [&](double impulse, double age) {
    snapshot.impacts = {{Vec2::Zero(), impulse, age}};
    return range_of(snapshot).seen.has(LegendEntry::impact);
  };
  EXPECT_TRUE(named(10.0, 0.5));
  EXPECT_FALSE(named(1e-3, 0.5));
  EXPECT_FALSE(named(10.0, 0.9));
}

TEST(FitScales, LoadsFitWhatIsTypicalAndSayThatThereIsMore) {
  Snapshot snapshot = test::pyramid_snapshot();
  const Layers layers{Layer::cubes};
  const auto colored = [&](const MotionRange& range) {
    PictureOptions options;
    options.layers = layers;
    options.size = {1280, 720};
    options.camera = parse_camera("0,2,10");
    options.color_by = ColorBy::load;
    options = fit_scales(options, range);
    options.legend = legend_of(options, range);
    return options;
  };
  MotionRange steady;
  for (int frame = 0; frame < 20; ++frame)
    steady.include(snapshot);
  const double largest = *colored(steady).color_top;
  EXPECT_DOUBLE_EQ(largest, std::ranges::max(loads(snapshot)));
  EXPECT_FALSE(colored(steady).legend->has(LegendEntry::above));
  MotionRange peaked = steady;
  snapshot.joints[0].force *= 1000.0;
  peaked.include(snapshot);
  EXPECT_LE(*colored(peaked).color_top, 1.1 * largest);
  EXPECT_TRUE(colored(peaked).legend->has(LegendEntry::above));
}

TEST(LegendOf, TellsOfWhiskersThatGoOn) {
  Snapshot snapshot = test::failing_snapshot();
  const auto goes_on = [&] {
    return legend_of(fitted({Layer::forces, Layer::whiskers}, range_of(snapshot)),
                     range_of(snapshot))
        .has(LegendEntry::beyond);
  };
  for (SnapshotJoint& joint : snapshot.joints)
    joint.range.reset();
  for (SnapshotForce& force : snapshot.forces)
    force.range.reset();
  snapshot.joints[0].range = {0.0, snapshot.joints[0].force.norm()};
  EXPECT_FALSE(goes_on());
  snapshot.joints[0].range->most = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(goes_on());
}

TEST(FitScales, ComparesAccelerationsWithFreeFall) {
  Snapshot snapshot = test::pyramid_snapshot();
  const double g = snapshot.gravity.norm();
  const auto arrow = [&] {
    return *fitted({Layer::accelerations}, range_of(snapshot)).acceleration_scale;
  };
  EXPECT_NEAR(arrow() * g, 0.4, 1e-12) << "sides";
  snapshot.boxes[6].acceleration = Vec2(0.0, 900.0);
  EXPECT_NEAR(arrow() * g, 0.4, 1e-12) << "whatever an impact does";
  EXPECT_NEAR(shown_acceleration(snapshot.boxes[6].acceleration, snapshot.gravity).y(), 3.0 * g,
              1e-12);
  EXPECT_TRUE(legend_of(fitted({Layer::accelerations}, range_of(snapshot)), range_of(snapshot))
                  .has(LegendEntry::cut));
}

TEST(FitScales, MakesForcesOfFreeBodiesShorter) {
  const MotionRange range = range_of(test::pyramid_snapshot());
  PictureOptions apart;
  apart.layers = {Layer::forces};
  const double joined = fit_scales(apart, range).force_scale->metres_per_newton;
  apart.explode = 0.3;
  const ForceScale scale = *fit_scales(apart, range).force_scale->whole;
  EXPECT_NEAR(scale.metres_per_newton, 0.6 * joined, 1e-15);
  EXPECT_LT(2.0 * scale.longest, 1.0) << "two forces from above and below don't meet";
}

}  // namespace
}  // namespace wuerfel::test
