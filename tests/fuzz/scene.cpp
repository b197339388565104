// Scenes in TOML and JSON: read or refused; what is read comes back equal from its normal form.
#include "core/scene/scene_parser.h"
#include "tests/fuzz/target.h"

// The normal form of a crowd takes seconds and says no more.
constexpr std::size_t most_cubes_twice = 1000;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wuerfel;
  try {
    const Scene scene = parse_scene(fuzz::text_of(data, size), "input");
    if (scene.cubes.size() > most_cubes_twice) return 0;
    const std::string normal = normalised_scene(scene);
    fuzz::require(normalised_scene(parse_scene(normal, "normal")) == normal);
  } catch (const SceneError&) {
  }
  return 0;
}
