/// Value -> JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "core/scene/value.h"

namespace wuerfel {

/// Dates and other values that JSON has not become null.
nlohmann::ordered_json json_of(const Value& value);

}  // namespace wuerfel
