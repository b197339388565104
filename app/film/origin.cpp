#include "app/film/origin.h"

#include <fmt/core.h>

namespace wuerfel {

PngText time_text(const std::vector<double>& times) {
  std::string text;
  for (const double t : times)
    text += fmt::format("{}{}", text.empty() ? "" : ",", t);
  return {time_key, text};
}

std::vector<PngText> origin_texts(const std::string& options, const std::string& normalised_scene) {
  return {{software_key, "wuerfel " WUERFEL_VERSION},
          {options_key, options},
          {scene_key, normalised_scene}};
}

std::string option_text(const MotionSettings& motion) {
  return fmt::format("--integrator {} --formulation {} --solver {} --tolerance {} --step {}",
                     to_string(motion.integrator), to_string(motion.formulation),
                     to_string(motion.solver), motion.tolerance, motion.step);
}

}  // namespace wuerfel
