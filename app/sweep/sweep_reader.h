/// What the entries of a sweep's file mean.
#pragma once

#include <optional>
#include <string_view>

#include "app/sweep/sweep_entries.h"
#include "app/sweep/sweep_file.h"
#include "core/scene/value.h"

namespace wuerfel {

/// A text in TOML or JSON. Throws SceneError.
Value read_document(std::string_view text, const SceneSource& source);

/// The sweep of the entries of one file; `scene` is the one of the command line. Throws SceneError.
Sweep read_sweep(const SweepEntries& entries,
                 const SceneSource& source,
                 const std::optional<SceneText>& scene);

}  // namespace wuerfel
