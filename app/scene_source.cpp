#include "app/scene_source.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <system_error>

#include <fmt/core.h>

#include "app/shipped_scenes.h"
#include "core/scene/scene_parser.h"
#include "core/scene/suggestion.h"

namespace wuerfel {

namespace {

constexpr std::size_t largest_scene = std::size_t{256}
                                      << 20;  // bytes: more is no scene but a mistake

std::string read_stream(std::istream& stream, const std::string& name) {
  std::string text;
  std::string block(std::size_t{1} << 16, '\0');
  while (stream.read(block.data(), static_cast<std::streamsize>(block.size()))
         || stream.gcount() > 0) {
    text.append(block, 0, static_cast<std::size_t>(stream.gcount()));
    if (text.size() > largest_scene) {
      throw SceneError(fmt::format("{}: more than {} MiB is no scene", name, largest_scene >> 20));
    }
  }
  if (stream.bad()) throw SceneError(fmt::format("{}: cannot be read", name));
  return text;
}

std::string read_file(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw SceneError(fmt::format("{}: is a folder, not a scene file", path));
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw SceneError(fmt::format("{}: {}", path, std::generic_category().message(errno)));
  return read_stream(file, path);
}

[[noreturn]] void unknown_source(const std::string& source) {
  std::vector<std::string_view> names;
  for (const ShippedScene& scene : shipped_scenes())
    names.push_back(scene.name);
  throw SceneError(fmt::format("{}: no such file, and no shipped scene of that name{}", source,
                               suggestion(source, names)));
}

/// Says what a scene asks for that the program does not compute, so that nothing is left out
/// silently.
Scene with_note(Scene scene) {
  bool friction = false;
  bool restitution = false;
  const auto look = [&](double mu, double e) {
    friction = friction || mu > 0.0;
    restitution = restitution || e > 0.0;
  };
  for (const SceneCube& cube : scene.cubes)
    look(cube.material.friction, cube.material.restitution);
  for (const ScenePair& pair : scene.pairs)
    look(pair.friction.value_or(0.0), pair.restitution.value_or(0.0));
  if (friction || restitution) {
    fmt::print(stderr,
               "wuerfel: note: the scene asks for {}, which is not computed: contacts are "
               "frictionless and impacts inelastic\n",
               friction && restitution ? "friction and restitution"
               : friction              ? "friction"
                                       : "restitution");
  }
  return scene;
}

Scene scene_of(const SceneChoice& choice) {
  const auto& [source, overrides] = choice;
  if (source == "-")
    return parse_scene(read_stream(std::cin, "standard input"), "standard input", overrides);
  std::error_code ignored;
  const bool folder = std::filesystem::is_directory(source, ignored);
  const bool file = std::filesystem::exists(source, ignored) && !folder;
  if (const ShippedScene* scene = find_shipped_scene(source); scene != nullptr && !file) {
    return parse_scene(scene->text, fmt::format("{}.toml", scene->name), overrides);
  }
  if (!file && !folder) unknown_source(source);
  return parse_scene(read_file(source), source, overrides);
}

}  // namespace

Scene read_scene(const SceneChoice& choice) { return with_note(scene_of(choice)); }

std::string text_hash(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3U;
  }
  return fmt::format("{:016x}", hash);
}

}  // namespace wuerfel
