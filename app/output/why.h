/// `explain --json`.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/words/explanation.h"

namespace wuerfel {

nlohmann::ordered_json why_json(const Explanation& explanation,
                                const std::vector<std::string>& text);

}  // namespace wuerfel
