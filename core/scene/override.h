/// Overrides of a scene's keys from the command line: `--set cube.a.angle=0.1`.
#pragma once

#include "core/scene/value.h"

namespace wuerfel {

/// Sets the key that source.overrides[index] names, "KEY=VALUE" with KEY one of
///   gravity                  a key of the document
///   material.friction        a key of a table
///   cube.a.angle             a key of the table with that name (given, or by default as in cube2),
///   or tower.1.count            with that number, from 1
/// The key need not have been there. Throws SceneError that names the override where KEY leads
/// nowhere.
void apply_override(Value& document, int index, const SceneSource& source);

}  // namespace wuerfel
