#include "app/commands/letters.h"

#include <string>
#include <vector>

#include <fmt/core.h>

#include "render/picture/font.h"

namespace wuerfel {

namespace {

// Hebrew, Arabic and their neighbours.
bool runs_leftwards(char32_t letter) {
  return (letter >= 0x590 && letter <= 0x8FF) || (letter >= 0xFB1D && letter <= 0xFEFC);
}

std::vector<std::string> texts_of(const Scene& scene, Layers layers) {
  std::vector<std::string> texts;
  if (layers.has(Layer::hud)) texts.push_back(scene.title);
  if (!layers.has(Layer::names)) return texts;
  for (const SceneCube& cube : scene.cubes)
    texts.push_back(cube.name);
  for (const SceneFixed& fixed : scene.fixed)
    texts.push_back(fixed.name);
  return texts;
}

}  // namespace

void note_letters(const Scene& scene, Layers layers, Notes& notes) {
  Font font;
  bool told_missing = false;
  bool told_direction = false;
  for (const std::string& text : texts_of(scene, layers)) {
    for (std::size_t at = 0; at < text.size();) {
      const char32_t letter = next_code_point(text, at);
      const auto number = static_cast<unsigned>(letter);
      if (!told_missing && letter >= 0x20 && font.glyph_index(letter) == 0) {
        notes.add(
            fmt::format("'{}': the font has no U+{:04X}: it is drawn as a box", text, number));
        told_missing = true;
      }
      if (!told_direction && runs_leftwards(letter)) {
        notes.add(
            fmt::format("'{}': writing from right to left is drawn from left to right, its "
                        "letters unjoined",
                        text));
        told_direction = true;
      }
    }
  }
}

}  // namespace wuerfel
