/// `check --json`.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/check.h"
#include "core/scene/scene.h"

namespace wuerfel {

/// Keys of the contract, without margins and ranges.
nlohmann::ordered_json check_json(const Scene& scene, const Check& answer);

}  // namespace wuerfel
