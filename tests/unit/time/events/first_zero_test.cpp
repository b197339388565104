// The search for first zeros, on functions whose zeros are known.
#include "core/time/events/first_zero.h"

#include <array>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "tests/support/random_motion.h"

namespace wuerfel::test {
namespace {

/// A function with derivatives and bounds that hold everywhere; counts looks.
struct Known {
  using Look = Sample;
  static constexpr double resolution = 1e-13;
  std::function<Jet(double)> f;
  DerivativeBounds bounds;
  int looks = 0;

  Sample at(double share) {
    ++looks;
    return {share, f(share)};
  }
  [[nodiscard]] bool positive_between(const Sample& a, const Sample& b, double shift) const {
    Jet from = a.jet;
    Jet to = b.jet;
    from.value += shift;
    to.value += shift;
    return no_zero_between(from, to, b.share - a.share, bounds);
  }
  [[nodiscard]] double second_bound(const Sample&, const Sample&) const { return bounds.second; }
};

/// c_0 + c_1 s + c_2 s^2 + c_3 s^3 on [0, 1].
struct Cubic {
  std::array<double, 4> c{};
  [[nodiscard]] Jet operator()(double s) const {
    return {c[0] + s * (c[1] + s * (c[2] + s * c[3])), c[1] + s * (2.0 * c[2] + 3.0 * s * c[3]),
            2.0 * c[2] + 6.0 * s * c[3]};
  }
  [[nodiscard]] Known known() const {
    const double second = std::max(std::abs(2.0 * c[2]), std::abs(2.0 * c[2] + 6.0 * c[3]));
    return {*this, {second, 6.0 * std::abs(c[3])}};
  }
};

/// (s - a)(s - b) + up
Cubic parabola(double a, double b, double up = 0.0) { return {{a * b + up, -a - b, 1.0, 0.0}}; }

FirstZero find(const Cubic& f, double end = 1.0, const Arming& arming = {}) {
  Known known = f.known();
  return first_zero(known, end, arming);
}

TEST(FirstZero, IsFoundToTheResolution) {
  for (const double root : {1e-9, 0.1, 0.5, 1.0 - 1e-9}) {
    const FirstZero found = find({{root, -1.0, 0.0, 0.0}});
    ASSERT_TRUE(found.share);
    EXPECT_NEAR(*found.share, root, 2e-13);
    EXPECT_GE(*found.share, root - 1e-16) << "the function is no longer positive there";
    EXPECT_FALSE(found.given_up);
  }
}

TEST(FirstZero, OfTwoIsTheFirst) {
  const FirstZero found = find(parabola(0.3, 0.6));
  ASSERT_TRUE(found.share);
  EXPECT_NEAR(*found.share, 0.3, 2e-13);
}

TEST(FirstZero, OfANarrowDipIsNotMissed) {
  for (const double width : {1e-2, 1e-4, 1e-6}) {
    for (const double middle : {0.37, 0.5, 0.93}) {
      const FirstZero found = find(parabola(middle - width, middle + width));
      ASSERT_TRUE(found.share) << width << ' ' << middle;
      EXPECT_NEAR(*found.share, middle - width, 1e-13 / width);
    }
  }
}

TEST(FirstZero, IsNotSaidOfADipThatStaysAbove) {
  for (const double up : {1e-2, 1e-6, 1e-10, 1e-13}) {
    Known f = parabola(0.37, 0.37, up).known();
    const FirstZero found = first_zero(f, 1.0, Arming{});
    EXPECT_FALSE(found.share) << up;
    EXPECT_FALSE(found.given_up);
    EXPECT_LT(f.looks, 60);
  }
}

TEST(FirstZero, ADoubleRootIsTouchedAndNotCrossed) {
  for (const double root : {0.25, 0.37}) {
    const FirstZero found = find(parabola(root, root));
    // Rounding decides whether 0.37 is a zero; 0.25 is none that is crossed.
    if (found.share) {
      EXPECT_NEAR(*found.share, root, 1e-7);
    }
    EXPECT_FALSE(found.given_up);
  }
}

TEST(FirstZero, ATripleRootIsFound) {
  // -(s - 0.4)^3
  const double r = 0.4;
  const FirstZero found = find({{r * r * r, -3.0 * r * r, 3.0 * r, -1.0}});
  ASSERT_TRUE(found.share);
  EXPECT_NEAR(*found.share, r, 1e-5);
}

TEST(FirstZero, IsLookedForUpToTheEndThatIsGiven) {
  EXPECT_FALSE(find({{0.5, -1.0, 0.0, 0.0}}, 0.4).share);
  EXPECT_TRUE(find({{0.5, -1.0, 0.0, 0.0}}, 0.6).share);
}

TEST(FirstZero, WhatStartsAtZeroIsArmedOnceItHasLeftIt) {
  const double zero = 1e-6;
  // s (0.3 - s): leaves zero and comes back.
  const Arming arming = Arming::at_start(0.0, zero);
  EXPECT_EQ(arming.shift, zero);
  const FirstZero found = find({{0.0, 0.3, -1.0, 0.0}}, 1.0, arming);
  ASSERT_TRUE(found.share);
  EXPECT_NEAR(*found.share, 0.3, 2e-13) << "without the addition";
  EXPECT_EQ(found.arming.shift, 0.0);
}

TEST(FirstZero, WhatStartsAtZeroAndFallsIsFoundBelowZero) {
  const Arming arming = Arming::at_start(-1e-9, 1e-6);
  const FirstZero found = find({{-1e-9, -1e-3, 0.0, 0.0}}, 1.0, arming);
  ASSERT_TRUE(found.share);
  EXPECT_NEAR(*found.share, 1e-3, 1e-12);
  EXPECT_NEAR(found.arming.shift, 1e-6 + 1e-9, 1e-20);
}

TEST(FirstZero, WhatStaysNearZeroIsNoEvent) {
  const Arming arming = Arming::at_start(0.0, 1e-6);
  EXPECT_FALSE(find({{0.0, 1e-9, -2e-9, 0.0}}, 1.0, arming).share);
}

TEST(FirstZero, OfManyCubicsIsWhereSamplesSeeIt) {
  Draw draw;
  int crossings = 0;
  for (int k = 0; k < 5000; ++k) {
    const Cubic f{{draw(1e-3, 1.0), draw(-4.0, 4.0), draw(-8.0, 8.0), draw(-8.0, 8.0)}};
    const FirstZero found = find(f);
    constexpr int samples = 2000;
    int first = 1;
    while (first <= samples && f(1.0 * first / samples).value > 0.0)
      ++first;
    ASSERT_FALSE(found.given_up);
    if (first > samples) {
      // A dip between two samples may be real: the value must say so.
      if (found.share) {
        EXPECT_LE(f(*found.share).value, 1e-15);
      }
      continue;
    }
    ++crossings;
    ASSERT_TRUE(found.share);
    EXPECT_LE(*found.share, 1.0 * first / samples);
    EXPECT_NEAR(f(*found.share).value, 0.0, 1e-11);
  }
  EXPECT_GT(crossings, 1500);
}

/// The larger one of two cubics, as the separation of boxes is that by the side that separates them best: proofs and bounds are
/// those of one of them.
struct Larger {
  struct Look : Sample {
    int best = 0;
  };
  static constexpr double resolution = 1e-13;
  std::array<Cubic, 2> f;

  [[nodiscard]] Look at(double share) const {
    const int best = f[1](share).value > f[0](share).value ? 1 : 0;
    return {{share, f[best](share)}, best};
  }
  [[nodiscard]] bool positive_between(const Look& a, const Look& b, double shift) const {
    const auto stays = [&](const Cubic& c) {
      return c.known().positive_between({a.share, c(a.share)}, {b.share, c(b.share)}, shift);
    };
    return stays(f[a.best]) || stays(f[b.best]);
  }
  [[nodiscard]] double second_bound(const Look& a, const Look& /*b*/) const {
    return f[a.best].known().bounds.second;
  }
};

TEST(FirstZero, IsNotSkippedWhereAnotherSideSeparatesAfterwards) {
  Draw draw;
  int crossings = 0;
  const auto cubic = [&] {
    return Cubic{{draw(-1.0, 1.0), draw(-4.0, 4.0), draw(-8.0, 8.0), draw(-8.0, 8.0)}};
  };
  for (int k = 0; k < 20000; ++k) {
    Larger f{{cubic(), cubic()}};
    if (f.at(0.0).jet.value <= 0.0) continue;
    const FirstZero found = first_zero(f, 1.0, Arming{});
    constexpr int samples = 500;
    int first = 1;
    while (first <= samples && f.at(1.0 * first / samples).jet.value > 0.0)
      ++first;
    if (first > samples) continue;
    ++crossings;
    ASSERT_TRUE(found.share);
    ASSERT_LE(*found.share, 1.0 * first / samples);
  }
  EXPECT_GT(crossings, 3000);
}

TEST(FirstZero, TakesFewLooksAtAFallingFunction) {
  Known f{
      [](double s) {
        return Jet{std::cos(1.2 * s) - 0.7, -1.2 * std::sin(1.2 * s), -1.44 * std::cos(1.2 * s)};
      },
      {1.44, 1.728}};
  const FirstZero found = first_zero(f, 1.0, Arming{});
  ASSERT_TRUE(found.share);
  EXPECT_NEAR(*found.share, std::acos(0.7) / 1.2, 2e-13);
  EXPECT_LE(f.looks, 16);
}

TEST(FirstZero, GivesUpWhereBoundsAreHopeless) {
  Known f{[](double s) { return Jet{1e-9 + 1e-12 * s, 0.0, 0.0}; }, {1e12, 1e18}};
  const FirstZero found = first_zero(f, 1.0, Arming{});
  EXPECT_FALSE(found.share);
  EXPECT_TRUE(found.given_up);
}

TEST(NoZeroBetween, IsNeverSaidOfAFunctionThatHasOne) {
  Draw draw;
  int cleared = 0;
  for (int k = 0; k < 20000; ++k) {
    // A cubic: its second derivative is linear, so that its bounds are exact.
    const Cubic f{{draw(0.0, 1.0), draw(-2.0, 2.0), draw(-4.0, 4.0), draw(-4.0, 4.0)}};
    if (!no_zero_between(f(0.0), f(1.0), 1.0, f.known().bounds)) continue;
    ++cleared;
    for (int i = 0; i <= 100; ++i)
      ASSERT_GT(f(i / 100.0).value, 0.0);
  }
  EXPECT_GT(cleared, 2000);
}

TEST(NoZeroBetween, IsSaidAtOnceOfAGapThatOpensFromZero) {
  // t^3, a release, with a bound of the second derivative that is much too large.
  const Jet a{1e-3, 0.0, 0.0};
  const Jet b{1.0, 3.0, 6.0};
  EXPECT_TRUE(no_zero_between(a, b, 1.0, {100.0, 6.0}));
  EXPECT_FALSE(no_zero_between(a, b, 1.0, {100.0, 100.0}));
}

}  // namespace
}  // namespace wuerfel::test
