/// A run that can be taken up again: a file with all that is needed to go on to the same bits.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/output/accuracy.h"
#include "core/scene/scene.h"
#include "core/settings.h"
#include "core/time/simulation.h"

namespace wuerfel {

struct Checkpoint {
  std::string restart_point;    ///< of the simulation; empty: its start
  std::vector<Moment> moments;  ///< frames and samples up to there, in their order
  std::optional<Violation> first_violation;
};

/// What a checkpoint belongs to: this version of the program, the scene and the options of the motion.
std::string checkpoint_origin(const Scene& scene, const MotionSettings& settings);

/// The file appears whole or not at all. Throws OutputError.
void write_checkpoint(const std::string& path,
                      const std::string& origin,
                      const Checkpoint& checkpoint);

/// Throws UsageError where the file is no checkpoint, is damaged, or belongs to another version, scene
/// or motion.
Checkpoint read_checkpoint(const std::string& path, const std::string& origin);
/// The same of its bytes; `name` stands for the file in messages.
Checkpoint parse_checkpoint(std::string_view bytes,
                            const std::string& name,
                            const std::string& origin);

}  // namespace wuerfel
