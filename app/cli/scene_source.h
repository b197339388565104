/// Where scenes come from: files, standard input, or the scenes that come along.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/streams.h"
#include "core/scene/scene.h"

namespace wuerfel {

struct SceneChoice {
  std::string source;  ///< path, `-` for standard input, or the name of a shipped scene
  std::vector<std::string> overrides;  ///< key=value
};

/// Throws SceneError. Notes what the scene asks for and the program does not compute.
Scene read_scene(const SceneChoice& choice);

/// A scene that has not been read yet.
struct SceneText {
  std::string name;  ///< of the file, for messages
  std::string text;
};

/// The text behind a path, `-`, or the name of a shipped scene. Throws SceneError.
SceneText scene_text(const std::string& source);

/// Throws SceneError.
Scene parse(const SceneText& text, const std::vector<std::string>& overrides);

/// The number of the cube or point that an option names. Throws UsageError where there is none.
int moving_number(const Scene& scene, std::string_view option, const std::string& name);

/// Scenes one by one. On standard input there may be one JSON scene a line, and no end in sight:
/// each is handed out as soon as its line is there.
class SceneQueue {
 public:
  explicit SceneQueue(std::vector<std::string> sources);
  /// None behind the last. Throws SceneError where there is no such file.
  std::optional<SceneText> next();
  /// Whether there may be more than one: more than one source, or lines. Known after the first.
  [[nodiscard]] bool several() const { return sources_.size() > 1 || lines_ > 0; }

 private:
  SceneText first_of_input();
  std::optional<SceneText> next_line();

  std::vector<std::string> sources_;
  std::size_t next_ = 0;  // of the sources
  int lines_ = 0;         // of standard input that were handed out; 0: it is one scene
  std::string ahead_;     // a line that has been read and not handed out
};

/// 64-bit FNV-1a of the text.
std::uint64_t text_number(std::string_view text);
/// The same in hexadecimal: names a scene in summaries.
std::string text_hash(std::string_view text);

}  // namespace wuerfel
