/// What `check` answers, to people who read JSON and exit codes.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/cli/exit_code.h"
#include "core/check.h"
#include "core/scene/scene.h"

namespace wuerfel {

/// Fine where it stands, negative where it falls or moves.
ExitCode exit_code(Verdict verdict);

/// Keys of the contract, without margins and ranges.
nlohmann::ordered_json check_json(const Scene& scene, const Check& answer);

}  // namespace wuerfel
