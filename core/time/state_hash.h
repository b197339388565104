/// A number for the states that a motion went through: equal where every bit of them is.
#pragma once

#include <bit>
#include <cstdint>

#include "core/model/state.h"

namespace wuerfel {

class StateHash {
 public:
  void add(double number) {
    value_ = (value_ ^ std::bit_cast<std::uint64_t>(number)) * prime;
    value_ ^= value_ >> 32U;
  }
  void add(double t, const State& state) {
    add(t);
    for (const BodyState& s : state) {
      for (const double number :
           {s.position.x(), s.position.y(), s.angle, s.velocity.x(), s.velocity.y(), s.spin})
        add(number);
    }
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }
  /// Goes on from the value of another.
  void set(std::uint64_t value) { value_ = value; }

 private:
  static constexpr std::uint64_t prime = 0x9E3779B97F4A7C15U;  ///< odd: no two numbers become one
  std::uint64_t value_ = 0xCBF29CE484222325U;
};

}  // namespace wuerfel
