/// The data set card: what somebody who finds a data set has to know.
#pragma once

#include <string>

#include "app/sweep/dataset.h"
#include "app/sweep/label_table.h"
#include "app/sweep/plan.h"

namespace wuerfel {

/// Markdown; a function of plan and labels: no date, no host.
std::string card(const Plan& plan, const LabelTable& labels, const DatasetCounts& counts);

}  // namespace wuerfel
