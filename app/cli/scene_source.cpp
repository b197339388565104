#include "app/cli/scene_source.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <system_error>
#include <utility>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/cli/argument.h"
#include "app/cli/exit_code.h"
#include "app/cli/is_folder.h"
#include "app/cli/shipped_scenes.h"
#include "core/scene/scene_parser.h"
#include "core/scene/suggestion.h"

namespace wuerfel {

namespace {

constexpr std::size_t largest_scene = std::size_t{256}
                                      << 20;  // bytes: more is no scene but a mistake

[[noreturn]] void refuse_as_too_large(const std::string& name) {
  throw SceneError(fmt::format("{}: more than {} MiB is no scene", name, largest_scene >> 20));
}

std::string read_stream(std::istream& stream, const std::string& name) {
  std::string text;
  std::string block(std::size_t{1} << 16, '\0');
  while (stream.read(block.data(), static_cast<std::streamsize>(block.size()))
         || stream.gcount() > 0) {
    text.append(block, 0, static_cast<std::size_t>(stream.gcount()));
    if (text.size() > largest_scene) refuse_as_too_large(name);
  }
  if (stream.bad()) throw SceneError(fmt::format("{}: cannot be read", name));
  return text;
}

// The next line of standard input without its end; false where there is none.
bool read_line(std::string& line) {
  constexpr int end = std::char_traits<char>::eof();
  line.clear();
  std::streambuf& input = *std::cin.rdbuf();
  int c = input.sbumpc();
  const bool there = c != end;
  for (; c != end && c != '\n'; c = input.sbumpc()) {
    line += static_cast<char>(c);
    if (line.size() > largest_scene) refuse_as_too_large("standard input");
  }
  return there;
}

std::string read_file(const std::string& path) {
  if (is_folder(path)) {
    throw SceneError(fmt::format("{}: is a folder, not a scene file", path));
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw SceneError(fmt::format("{}: {}", path, std::generic_category().message(errno)));
  return read_stream(file, path);
}

[[noreturn]] void unknown_source(const std::string& source) {
  throw SceneError(fmt::format("{}: no such file, and no shipped scene of that name{}", source,
                               suggestion(source, shipped_scenes(), &ShippedScene::name)));
}

bool is_blank(const std::string& line) {
  return line.find_first_not_of(" \t\r") == std::string::npos;
}

}  // namespace

SceneText scene_text(const std::string& source) {
  if (source == "-") return {"standard input", read_stream(std::cin, "standard input")};
  std::error_code ignored;
  const bool folder = is_folder(source);
  const bool file = std::filesystem::exists(source, ignored) && !folder;
  if (const ShippedScene* scene = find_shipped_scene(source); scene != nullptr && !file)
    return {fmt::format("{}.toml", scene->name), std::string(scene->text)};
  if (!file && !folder) unknown_source(source);
  return {source, read_file(source)};
}

Scene parse(const SceneText& text, const std::vector<std::string>& overrides) {
  if (has_suffix(text.name, ".jsonl") && !nlohmann::json::accept(text.text)) {
    throw SceneError(fmt::format(
        "{0}: is not one scene; check and run read a scene a line from standard input: - < {0}",
        text.name));
  }
  return parse_scene(text.text, text.name, overrides);
}

Scene read_scene(const SceneChoice& choice) {
  return parse(scene_text(choice.source), choice.overrides);
}

int moving_number(const Scene& scene, std::string_view option, const std::string& name) {
  const std::size_t count = scene.cubes.size() + scene.points.size();
  std::vector<std::string_view> known;
  known.reserve(count);
  for (std::size_t k = 0; k < count; ++k)
    known.emplace_back(moving_name(scene, static_cast<int>(k)));
  const auto at = std::ranges::find(known, name);
  if (at != known.end()) return static_cast<int>(at - known.begin());
  throw UsageError(
      fmt::format("{}: there is no cube '{}'{}", option, name, suggestion(name, known)));
}

SceneQueue::SceneQueue(std::vector<std::string> sources) : sources_(std::move(sources)) {}

std::optional<SceneText> SceneQueue::next() {
  if (lines_ > 0) {
    if (auto line = next_line()) return line;
  }
  if (next_ == sources_.size()) return std::nullopt;
  const std::string& source = sources_[next_++];
  return source == "-" ? first_of_input() : scene_text(source);
}

// Where the first line is a whole scene, and another follows, there is one on every line.
SceneText SceneQueue::first_of_input() {
  std::string head;
  std::string line;
  while (is_blank(line) && read_line(line))
    head += line + '\n';
  if (!nlohmann::json::accept(line))
    return {"standard input", head + read_stream(std::cin, "standard input")};
  while (is_blank(ahead_) && read_line(ahead_)) {
  }
  if (is_blank(ahead_)) return {"standard input", head};
  lines_ = 1;
  return {"standard input, scene 1", line};
}

std::optional<SceneText> SceneQueue::next_line() {
  while (is_blank(ahead_) && read_line(ahead_)) {
  }
  if (is_blank(ahead_)) return std::nullopt;
  return SceneText{fmt::format("standard input, scene {}", ++lines_), std::exchange(ahead_, {})};
}

std::uint64_t text_number(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3U;
  }
  return hash;
}

std::string text_hash(std::string_view text) { return fmt::format("{:016x}", text_number(text)); }

}  // namespace wuerfel
