// Colours that mean something different can be told apart by readers of every kind of colour vision.
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "render/picture/style.h"

namespace wuerfel::test {
namespace {

using Rgb = std::array<double, 3>;
using Matrix = std::array<Rgb, 3>;

Rgb product(const Matrix& m, const Rgb& v) {
  Rgb result{};
  for (std::size_t i = 0; i < 3; ++i)
    result.at(i) = m.at(i)[0] * v[0] + m.at(i)[1] * v[1] + m.at(i)[2] * v[2];
  return result;
}

double linear(double channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// CIE 1976 L*a*b* under D65 of linear sRGB.
Rgb lab(const Rgb& rgb) {
  constexpr Matrix xyz{{{0.4124564, 0.3575761, 0.1804375},
                        {0.2126729, 0.7151522, 0.0721750},
                        {0.0193339, 0.1191920, 0.9503041}}};
  Rgb clipped{};
  for (std::size_t i = 0; i < 3; ++i)
    clipped.at(i) = std::min(std::max(rgb.at(i), 0.0), 1.0);
  const Rgb white = product(xyz, {1.0, 1.0, 1.0});
  Rgb f = product(xyz, clipped);
  for (std::size_t i = 0; i < 3; ++i) {
    const double t = f.at(i) / white.at(i);
    f.at(i) = t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0;
  }
  return {116.0 * f[1] - 16.0, 500.0 * (f[0] - f[1]), 200.0 * (f[1] - f[2])};
}

/// Full severity, of linear RGB: Machado, Oliveira, Fernandes 2009, table of supplementary material.
struct Vision {
  std::string name;
  Matrix seen;
};
const std::vector<Vision>& visions() {
  static const std::vector<Vision> all{
      {"normal", {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}}},
      {"deuteranopia",
       {{{0.367322, 0.860646, -0.227968},
         {0.280085, 0.672501, 0.047413},
         {-0.011820, 0.042940, 0.968881}}}},
      {"protanopia",
       {{{0.152286, 1.052583, -0.204868},
         {0.114503, 0.786281, 0.099216},
         {-0.003882, -0.048116, 1.051998}}}},
      {"tritanopia",
       {{{1.255528, -0.076749, -0.178779},
         {-0.078411, 0.930809, 0.147602},
         {0.004733, 0.691367, 0.303900}}}}};
  return all;
}

double difference(Color a, Color b, const Vision& vision) {
  const auto seen = [&](Color c) {
    return lab(product(vision.seen, {linear(c.r), linear(c.g), linear(c.b)}));
  };
  const Rgb p = seen(a);
  const Rgb q = seen(b);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

TEST(ColorVision, MeasureKnowsWhatCannotBeToldApart) {
  EXPECT_LT(difference(rgb(0x1F8A5B), rgb(0xC2255C), visions()[1]), 3.0) << "of an earlier theme";
  EXPECT_NEAR(difference(rgb(0x000000), rgb(0xFFFFFF), visions()[0]), 100.0, 0.1);
}

using Meanings = std::vector<std::pair<std::string, Color>>;

void expect_apart(const Meanings& meanings, const Vision& vision) {
  for (std::size_t i = 0; i < meanings.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GE(difference(meanings[i].second, meanings[j].second, vision), 15.0)
          << meanings[i].first << " and " << meanings[j].first;
    }
  }
}

TEST(ColorVision, MeaningsDifferByAtLeast15) {
  for (const Theme theme : {Theme::light, Theme::dark, Theme::transparent}) {
    const Style style = make_style(theme);
    const Meanings meanings{{"contact", style.contact},
                            {"friction", style.friction},
                            {"tension", style.tension},
                            {"compression", style.compression},
                            {"velocity", style.velocity},
                            {"acceleration", style.acceleration},
                            {"weight", style.own_weight},
                            {"thrust", style.thrust},
                            {"whisker", style.whisker},
                            {"mechanism", style.mechanism},
                            {"cause", style.cause},
                            {"normal", style.normal},
                            {"positive side", style.positive_side},
                            {"negative side", style.negative_side}};
    for (const Vision& vision : visions()) {
      SCOPED_TRACE(vision.name);
      SCOPED_TRACE(to_string(theme));
      expect_apart(meanings, vision);
    }
  }
}

}  // namespace
}  // namespace wuerfel::test
