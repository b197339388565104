#include "app/sweep/distribution.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>

namespace wuerfel {

namespace {

constexpr double ln2_high = 0x1.62e42fefap-1;  // 37 bits: products with small integers are exact
constexpr double ln2_low = 0x1.cf79abc9e3b39p-40;

double polynomial(std::span<const double> highest_first, double x) {
  double sum = 0.0;
  for (const double coefficient : highest_first)
    sum = sum * x + coefficient;
  return sum;
}

std::string text_of(double value) { return fmt::format("{}", value); }

// Of `count` equally likely things the one at u.
std::int64_t index_at(double u, std::int64_t count) {
  return std::min(static_cast<std::int64_t>(u * static_cast<double>(count)), count - 1);
}

double between(const NumberPair& ends, double u) {
  return std::clamp(ends.first + u * (ends.second - ends.first), ends.first, ends.second);
}

struct ValueAt {
  double u;

  std::string operator()(const Uniform& draw) const { return text_of(between(draw.ends, u)); }
  std::string operator()(const LogUniform& draw) const {
    const auto [low, high] = draw.ends;
    const double log = between({portable_log(low), portable_log(high)}, u);
    return text_of(std::clamp(portable_exp(log), low, high));
  }
  std::string operator()(const Normal& draw) const {
    const auto [mean, deviation] = draw.mean_and_deviation;
    const double value = mean + deviation * normal_quantile(u);
    return text_of(draw.clip ? std::clamp(value, draw.clip->first, draw.clip->second) : value);
  }
  std::string operator()(const Integers& draw) const {
    return fmt::format("{}", draw.low + index_at(u, draw.high - draw.low + 1));
  }
  std::string operator()(const OneOf& draw) const {
    return draw.texts[index_at(u, static_cast<std::int64_t>(draw.texts.size()))];
  }
};

}  // namespace

std::string value_at(const Distribution& distribution, double u) {
  return std::visit(ValueAt{u}, distribution);
}

std::vector<std::string> all_values(const Distribution& distribution) {
  if (const auto* list = std::get_if<OneOf>(&distribution)) return list->texts;
  std::vector<std::string> values;
  if (const auto* range = std::get_if<Integers>(&distribution)) {
    for (std::int64_t value = range->low; value <= range->high; ++value)
      values.push_back(fmt::format("{}", value));
  }
  return values;
}

// log x = e ln 2 + 2 artanh z with z = (m - 1) / (m + 1), |z| < 0.172; the series of artanh z / z in
// z^2 ends where its terms are below rounding.
double portable_log(double x) {
  constexpr int terms = 12;
  int e = 0;
  double m = std::frexp(x, &e);
  if (m < 0x1.6a09e667f3bcdp-1) {  // 1 / sqrt 2
    m *= 2.0;
    --e;
  }
  const double z = (m - 1.0) / (m + 1.0);
  double series = 0.0;
  for (int k = terms; k > 0; --k)
    series = (series + 1.0 / (2 * k + 1)) * z * z;
  return e * ln2_high + (2.0 * z + (2.0 * z * series + e * ln2_low));
}

// e^x = 2^k e^r with |r| <= ln 2 / 2, e^r by its series.
double portable_exp(double x) {
  constexpr int terms = 15;
  const double k = std::nearbyint(x / (ln2_high + ln2_low));
  const double r = (x - k * ln2_high) - k * ln2_low;
  double series = 0.0;
  for (int n = terms; n > 0; --n)
    series = (series + 1.0) * r / n;
  return std::ldexp(1.0 + series, static_cast<int>(k));
}

double normal_quantile(double p) {
  constexpr std::array a{2.5090809287301226727e+3, 3.3430575583588128105e+4,
                         6.7265770927008700853e+4, 4.5921953931549871457e+4,
                         1.3731693765509461125e+4, 1.9715909503065514427e+3,
                         1.3314166789178437745e+2, 3.3871328727963666080e+0};
  constexpr std::array b{5.2264952788528545610e+3, 2.8729085735721942674e+4,
                         3.9307895800092710610e+4, 2.1213794301586595867e+4,
                         5.3941960214247511077e+3, 6.8718700749205790830e+2,
                         4.2313330701600911252e+1, 1.0};
  constexpr std::array c{7.74545014278341407640e-4, 2.27238449892691845833e-2,
                         2.41780725177450611770e-1, 1.27045825245236838258e+0,
                         3.64784832476320460504e+0, 5.76949722146069140550e+0,
                         4.63033784615654529590e+0, 1.42343711074968357734e+0};
  constexpr std::array d{1.05075007164441684324e-9, 5.47593808499534494600e-4,
                         1.51986665636164571966e-2, 1.48103976427480074590e-1,
                         6.89767334985100004550e-1, 1.67638483018380384940e+0,
                         2.05319162663775882187e+0, 1.0};
  constexpr std::array e{2.01033439929228813265e-7, 2.71155556874348757815e-5,
                         1.24266094738807843860e-3, 2.65321895265761230930e-2,
                         2.96560571828504891230e-1, 1.78482653991729133580e+0,
                         5.46378491116411436990e+0, 6.65790464350110377720e+0};
  constexpr std::array f{2.04426310338993978564e-15, 1.42151175831644588870e-7,
                         1.84631831751005468180e-5,  7.86869131145613259100e-4,
                         1.48753612908506148525e-2,  1.36929880922735805310e-1,
                         5.99832206555887937690e-1,  1.0};
  const double q = p - 0.5;
  if (std::abs(q) <= 0.425) {
    const double r = 0.180625 - q * q;
    return q * polynomial(a, r) / polynomial(b, r);
  }
  const double r = std::sqrt(-portable_log(q < 0.0 ? p : 1.0 - p));
  const double tail = r <= 5.0 ? polynomial(c, r - 1.6) / polynomial(d, r - 1.6)
                               : polynomial(e, r - 5.0) / polynomial(f, r - 5.0);
  return q < 0.0 ? -tail : tail;
}

}  // namespace wuerfel
