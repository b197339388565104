/// Distributions of the values that a sweep varies: functions of one number that is uniform in
/// (0, 1), so that random and stratified draws share them. From + - * / and sqrt alone: the same
/// bits on every machine.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace wuerfel {

/// Lower and upper end, or mean and standard deviation.
struct NumberPair {
  double first = 0.0;
  double second = 0.0;
};

struct Uniform {
  NumberPair ends;
};
struct LogUniform {
  NumberPair ends;
};
/// Cut off (not squeezed) at the ends of `clip`: draws beyond become the end.
struct Normal {
  NumberPair mean_and_deviation;
  std::optional<NumberPair> clip;
};
/// Whole numbers from one to another, both included.
struct Integers {
  std::int64_t low = 0;
  std::int64_t high = 0;
};
/// One of these values, each written as in TOML and JSON.
struct OneOf {
  std::vector<std::string> texts;
};

using Distribution = std::variant<Uniform, LogUniform, Normal, Integers, OneOf>;

/// The value at `u` in (0, 1), written as in TOML and JSON with the fewest digits that bring back
/// the same double.
std::string value_at(const Distribution& distribution, double u);

/// All values there are, in order; nothing where they are no list.
std::vector<std::string> all_values(const Distribution& distribution);

/// Natural logarithm of x > 0, within 2e-16 of its size.
double portable_log(double x);
/// e to the power x, |x| < 700, within 3e-16 of its size.
double portable_exp(double x);
/// Quantile of the standard normal distribution at p in (0, 1), within 1e-15 of its size [Wichura
/// 1988: "Algorithm AS 241: the percentage points of the normal distribution"].
double normal_quantile(double p);

}  // namespace wuerfel
