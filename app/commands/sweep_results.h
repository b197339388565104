/// What a plan has come to: how far it is, its data set, a picture of it.
#pragma once

#include "app/commands/commands.h"

namespace wuerfel {

Action declare_status(Options& options);
Action declare_merge(Options& options);
Action declare_sheet(Options& options);

}  // namespace wuerfel
