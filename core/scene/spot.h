/// Reading single values: what stands at one spot of the tree, checked for type and range.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/scene/entries.h"
#include "core/scene/value.h"

namespace wuerfel {

/// A value together with what a complaint about it needs.
struct Spot {
  const SceneSource& source;
  const Value& value;
  const std::string& table;  ///< path of the table it stands in, empty for the document
  std::string_view key;
  int element = 0;  ///< 1-based place in an array, 0: the value itself

  [[nodiscard]] std::string path() const;
  [[noreturn]] void fail(const std::string& message) const;
};

/// Each throws SceneError where the value has the wrong type or leaves the limits.
/// @{
void read(const Spot& spot, const Limits& limits, double& target);
void read(const Spot& spot, const Limits& limits, std::int64_t& target);
void read(const Spot& spot, const Limits& limits, std::string& target);
void read(const Spot& spot, const Limits& limits, Vec2& target);
void read(const Spot& spot, const Limits& limits, Size& target);
void read(const Spot& spot, const Limits& limits, Region& target);
void read(const Spot& spot, const Limits& limits, std::array<std::string, 2>& target);
void read(const Spot& spot, const Limits& limits, bool& target);
void read(const Spot& spot, const Limits& limits, PlaceEntry& target);
void read(const Spot& spot, const Limits& limits, Rgb& target);

/// Index of the name that stands there.
int read_choice(const Spot& spot, std::span<const std::string_view> names);

template <class T>
requires std::is_enum_v<T>
void read(const Spot& spot, const Limits& /*limits*/, T& target) {
  target = static_cast<T>(read_choice(spot, choices(T{})));
}

template <class T>
void read(const Spot& spot, const Limits& limits, std::optional<T>& target) {
  T present{};
  read(spot, limits, present);
  target = present;
}
/// @}

}  // namespace wuerfel
