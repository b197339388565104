/// Joints: rods and pins, their places resolved and checked.
#pragma once

#include <vector>

#include "core/scene/groups.h"

namespace wuerfel {

struct JointEntries {
  std::vector<RodEntry> rods;
  std::vector<PinEntry> pins;
};

/// Takes over rods and pins, once all bodies are in their places. Throws SceneError where a place names no body or no
/// part of it, where nothing is joined that could move against each other, where a rod has no length or not the one
/// that is asked for, and where the places of a pin do not coincide.
void add_joints(Scene& scene,
                const JointEntries& entries,
                const BodyNames& names,
                const SceneSource& source);

}  // namespace wuerfel
