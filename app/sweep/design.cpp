#include "app/sweep/design.h"

#include <numeric>
#include <utility>

#include "app/cli/scene_source.h"
#include "core/scene/counter_random.h"

namespace wuerfel {

namespace {

// Variables have streams of their own, whatever stands before them in the file.
std::uint64_t stream_of(const Sweep& sweep, std::size_t variable) {
  return random_bits(sweep.seed, text_number(sweep.variables[variable].key));
}

// In (0, 1): the middles of 2^52 equal parts, all of them exact.
double open_unit(std::uint64_t bits) { return (static_cast<double>(bits >> 12U) + 0.5) * 0x1p-52; }

// A permutation of 0 .. n-1 [Fisher and Yates 1938; Durstenfeld 1964].
std::vector<long> shuffled(long n, std::uint64_t stream) {
  std::vector<long> order(n);
  std::iota(order.begin(), order.end(), 0L);
  for (long i = n - 1; i > 0; --i) {
    const double u = random_unit(stream, static_cast<std::uint64_t>(i));
    std::swap(order[i], order[static_cast<long>(u * static_cast<double>(i + 1))]);
  }
  return order;
}

}  // namespace

Design::Design(const Sweep& sweep) : sweep_(sweep) {
  for (std::size_t v = 0; v < sweep.variables.size(); ++v) {
    if (sweep.sampling == Sampling::grid)
      lists_.push_back(all_values(sweep.variables[v].distribution));
    if (sweep.sampling == Sampling::latin)
      strata_.push_back(shuffled(sweep.cases, ~stream_of(sweep, v)));
  }
}

std::optional<long> Design::size() const {
  if (sweep_.sampling == Sampling::random) return std::nullopt;
  return sweep_.cases;
}

double Design::position(std::size_t variable, long candidate, long attempt) const {
  const std::uint64_t own =
      random_bits(stream_of(sweep_, variable), static_cast<std::uint64_t>(candidate));
  const double u = open_unit(random_bits(own, static_cast<std::uint64_t>(attempt)));
  if (sweep_.sampling != Sampling::latin) return u;
  return (static_cast<double>(strata_[variable][candidate]) + u)
         / static_cast<double>(sweep_.cases);
}

// The last variable changes fastest.
std::vector<std::string> Design::grid_values(long candidate) const {
  std::vector<std::string> values(lists_.size());
  for (std::size_t v = lists_.size(); v-- > 0;) {
    const auto count = static_cast<long>(lists_[v].size());
    values[v] = lists_[v][candidate % count];
    candidate /= count;
  }
  return values;
}

std::vector<std::string> Design::values(long candidate, long attempt) const {
  if (sweep_.sampling == Sampling::grid) return grid_values(candidate);
  std::vector<std::string> values;
  for (std::size_t v = 0; v < sweep_.variables.size(); ++v)
    values.push_back(value_at(sweep_.variables[v].distribution, position(v, candidate, attempt)));
  return values;
}

}  // namespace wuerfel
