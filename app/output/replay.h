/// Solving programs again that were kept in a file.
#pragma once

#include <functional>
#include <string>

#include <nlohmann/json.hpp>

namespace wuerfel {

/// Each program of a file that `run --failed-programs` wrote, solved by every solver, or where something rubs by that of Coulomb's law: {"program":
/// its number, "unknowns", "rows", "answers": [{"solver", "status", "residual", "iterations"}, ..]},
/// first the answer of the solver that runs use. Throws UsageError.
void replay_programs(const std::string& path,
                     const std::function<void(const nlohmann::ordered_json&)>& show);

}  // namespace wuerfel
