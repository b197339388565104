/// Margins and force ranges, for people and as JSON.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "core/statics/margins.h"
#include "core/statics/ranges.h"

namespace wuerfel {

/// Adds "margin": keys as in `check --json`. What has no limit is null; what no such change makes
/// stand is left out.
void add_margins(const StillScene& still,
                 const Margins& margins,
                 const MarginRequest& request,
                 nlohmann::ordered_json& json);

/// Adds "min" and "max" to every contact that was asked for, "degree" and "interfaces".
void add_ranges(const StillScene& still, const ForceRanges& ranges, nlohmann::ordered_json& json);

std::string margins_text(const StillScene& still,
                         const Margins& margins,
                         const MarginRequest& request);
std::string ranges_text(const StillScene& still, const ForceRanges& ranges);

}  // namespace wuerfel
