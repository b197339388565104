/// A set of enumerators, in one word.
#pragma once

#include <cstdint>
#include <initializer_list>

namespace wuerfel {

template <typename Enum>
class EnumSet {
 public:
  constexpr EnumSet() = default;
  constexpr EnumSet(std::initializer_list<Enum> members) {
    for (const Enum member : members)
      insert(member);
  }
  constexpr void insert(Enum member) { bits_ |= bit(member); }
  constexpr void erase(Enum member) { bits_ &= ~bit(member); }
  constexpr bool has(Enum member) const { return (bits_ & bit(member)) != 0; }
  friend constexpr bool operator==(EnumSet, EnumSet) = default;

 private:
  static constexpr std::uint32_t bit(Enum member) {
    return 1U << static_cast<std::uint32_t>(member);
  }
  std::uint32_t bits_ = 0;
};

}  // namespace wuerfel
