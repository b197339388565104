/// Random numbers that are a function of seed and counter: the same on every machine, in any order.
#pragma once

#include <cstdint>

namespace wuerfel {

/// Number `counter` (from 0) of the SplitMix64 sequence with this seed
/// [Steele, Lea, Flood 2014].
constexpr std::uint64_t random_bits(std::uint64_t seed, std::uint64_t counter) {
  std::uint64_t z = seed + (counter + 1U) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

/// Uniform in [0, 1): the upper 53 bits, exact.
constexpr double random_unit(std::uint64_t seed, std::uint64_t counter) {
  return static_cast<double>(random_bits(seed, counter) >> 11U) * 0x1p-53;
}

}  // namespace wuerfel
