/// Readable names for the parameters of tests, in letters that GoogleTest allows.
#pragma once

#include <array>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "core/settings.h"

namespace wuerfel::test {

/// -0.25 is "minus0p25", 1e-09 is "1eminus09".
inline std::string number_name(double number) {
  std::ostringstream digits;
  digits << number;
  std::string name;
  for (const char c : digits.str()) {
    if (c == '-') {
      name += "minus";
    } else if (c != '+') {
      name += c == '.' ? 'p' : c;
    }
  }
  return name;
}

/// For INSTANTIATE_TEST_SUITE_P over numbers.
template <typename Number>
std::string name_of_number(const ::testing::TestParamInfo<Number>& tested) {
  return number_name(static_cast<double>(tested.param));
}

/// The same over integrators, and all that there are.
inline std::string name_of_integrator(const ::testing::TestParamInfo<Integrator>& tested) {
  return std::string(to_string(tested.param));
}
inline constexpr std::array all_integrators{Integrator::automatic,  Integrator::event,
                                            Integrator::rattle,     Integrator::moreau,
                                            Integrator::symplectic, Integrator::euler};

}  // namespace wuerfel::test
