/// Values as answers in JSON show them.
#pragma once

#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>

#include "core/geometry/vec2.h"

namespace wuerfel {

/// Zero has no sign; what is not finite is null.
inline nlohmann::ordered_json number_json(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value + 0.0)
                              : nlohmann::ordered_json(nullptr);
}

inline nlohmann::ordered_json vector_json(const Vec2& v) { return {v.x() + 0.0, v.y() + 0.0}; }

inline nlohmann::ordered_json vector_json(const std::optional<Vec2>& v) {
  return v ? vector_json(*v) : nlohmann::ordered_json(nullptr);
}

}  // namespace wuerfel
