/// Readable names for the parameters of tests, in letters that GoogleTest allows.
#pragma once

#include <sstream>
#include <string>

#include <gtest/gtest.h>

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

}  // namespace wuerfel::test
