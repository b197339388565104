/// A contact sheet: first frames and labels of cases of a plan, in one picture to look at.
#pragma once

#include <optional>

#include "app/cli/stop_signal.h"
#include "app/film/still.h"
#include "app/sweep/plan.h"
#include "render/picture/film_strip.h"

namespace wuerfel {

struct SheetChoice {
  StripGrid grid{8, 8};
  std::optional<PixelSize> size;  ///< none: 1600x1760, without rows that would be empty
};

/// As many cases as the grid has cells, evenly spread over the plan, each with its verdict.
Still contact_sheet(const Plan& plan,
                    const SheetChoice& choice,
                    const StopSignal& stop,
                    Font& font);

}  // namespace wuerfel
