/// What is known of why a scene stands or falls, and how it is said.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/words/language.h"
#include "core/check.h"
#include "core/statics/fixes.h"
#include "core/statics/margins.h"

namespace wuerfel {

struct Explanation {
  Check check;
  std::optional<StillScene> still;  ///< none where something moves
  Causes causes;                    ///< of a scene that falls
  std::vector<Fix> fixes;
  std::optional<Weakest> weakest;        ///< of one that stands
  std::optional<TiltMargin> tilt_given;  ///< of one that stands and rubs: how far forces exist
  std::optional<TiltMargin> tilt;        ///< of one that stands, if nothing could slide
};

Explanation explain(const Scene& scene, const MotionSettings& settings);

/// Sentences, the most important first.
std::vector<std::string> sentences(const Scene& scene,
                                   const Explanation& explanation,
                                   Language language);

/// Cubes and points that move from the start.
std::vector<std::string> moving_names(const Scene& scene);

/// How all moves together where no part fails alone.
std::vector<std::string> mechanism_sentences(const Explanation& explanation, Language language);
/// One cause, and one fix, in a sentence.
std::string cause_sentence(const StillScene& still, const Cause& cause, Language language);
std::string fix_sentence(const StillScene& still, const Fix& fix, Language language);

}  // namespace wuerfel
