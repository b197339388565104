/// wuerfel sweep: data sets by the million.
#pragma once

#include <span>

#include "app/commands/commands.h"

namespace wuerfel {

/// plan, run, status, merge, verify, sheet, template.
std::span<const Command> sweep_commands();

}  // namespace wuerfel
