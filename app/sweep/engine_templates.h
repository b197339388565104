/// Scripts that run a sweep on engines that are there already.
#pragma once

#include <span>
#include <string_view>

namespace wuerfel {

struct EngineTemplate {
  std::string_view engine;
  std::string_view text;
};

std::span<const EngineTemplate> engine_templates();

}  // namespace wuerfel
