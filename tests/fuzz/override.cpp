// --set: lines of KEY=VALUE over a small scene.
#include <sstream>
#include <vector>

#include "core/scene/scene_parser.h"
#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wuerfel;
  std::istringstream lines(fuzz::text_of(data, size));
  std::vector<std::string> overrides;
  for (std::string line; std::getline(lines, line);)
    overrides.push_back(line);
  try {
    (void)parse_scene(
        "[[plane]]\n[[cube]]\nname = \"a\"\non = \"plane1\"\n[[tower]]\ncount = 2\nbase = [3, 0]\n",
        "scene", overrides);
  } catch (const SceneError&) {
  }
  return 0;
}
