// For schema_test.py: without arguments prints the JSON Schema; with --parse reads one JSON scene a
// line and answers each with "ok" or the message of the SceneError; with --normalise FILE [LOCALE] prints
// the file's normalised scene, in that locale.
#include <fstream>
#include <iostream>
#include <locale>
#include <sstream>
#include <string>

#include "core/scene/scene_parser.h"

namespace {

std::string answer(const std::string& text) {
  try {
    wuerfel::parse_scene(text, "line");
  } catch (const wuerfel::SceneError& error) {
    return error.what();
  }
  return "ok";
}

}  // namespace

int main(int argc, char** argv) {
  const std::string mode = argc > 1 ? argv[1] : "";
  if (mode == "--parse") {
    for (std::string line; std::getline(std::cin, line);) {
      std::cout << answer(line) << '\n';
    }
  } else if (mode == "--normalise" && argc >= 3) {
    if (argc > 3) std::locale::global(std::locale(argv[3]));
    const std::ifstream file(argv[2]);
    std::ostringstream text;
    text << file.rdbuf();
    std::cout << wuerfel::normalised_scene(wuerfel::parse_scene(text.str(), argv[2])) << '\n';
  } else {
    std::cout << wuerfel::scene_schema();
  }
  return 0;
}
