#include "app/output/checkpoint.h"

#include <fstream>
#include <utility>

#include <fmt/core.h>

#include "app/cli/scene_source.h"
#include "app/film/origin.h"
#include "app/output/text_output.h"
#include "core/scene/scene_parser.h"
#include "core/time/archive.h"
#include "render/files/file_bytes.h"

namespace wuerfel {

namespace {

constexpr std::string_view magic = "wuerfel checkpoint\n";

template <class Archive>
void transfer_violation(Archive& archive, std::optional<Violation>& violation) {
  bool there = violation.has_value();
  archive(there);
  if (!there) return;
  if (!violation) violation.emplace();
  transfer_all(archive, violation->promise, violation->t, violation->bodies, violation->text);
}

template <class Archive>
void transfer_checkpoint(Archive& archive, Checkpoint& checkpoint) {
  archive(checkpoint.restart_point);
  checkpoint.moments.resize(archive.count(checkpoint.moments.size()));
  for (Moment& moment : checkpoint.moments)
    transfer_all(archive, moment.t, moment.state, moment.loaded);
  transfer_violation(archive, checkpoint.first_violation);
}

// The next line, which is cut off.
std::string_view next_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

// What of the origins differs: they have a version, a scene and a motion, each on a line.
std::string_view difference(std::string_view theirs, std::string_view ours) {
  for (const std::string_view what :
       {"another version of wuerfel", "another scene", "other options of the motion"}) {
    if (next_line(theirs) != next_line(ours)) return what;
  }
  return "";
}

}  // namespace

std::string checkpoint_origin(const Scene& scene, const MotionSettings& settings) {
  return fmt::format("{} {}\n{}\n{}\n", WUERFEL_VERSION, sizeof(Moment),
                     text_hash(normalised_scene(scene)), option_text(settings));
}

void write_checkpoint(const std::string& path,
                      const std::string& origin,
                      const Checkpoint& checkpoint) {
  ArchiveWriter writer;
  Checkpoint copy = checkpoint;
  transfer_checkpoint(writer, copy);
  TextOutput file(path);
  file.write(fmt::format("{}{}\n{}", magic, text_hash(origin + writer.bytes()), origin));
  file.write(writer.bytes());
  file.finish();
}

Checkpoint parse_checkpoint(std::string_view bytes,
                            const std::string& name,
                            const std::string& origin) {
  const auto refuse = [&](std::string_view why) {
    throw UsageError(fmt::format("--resume: {} {}", name, why));
  };
  if (!bytes.starts_with(magic)) refuse("is no checkpoint");
  bytes.remove_prefix(magic.size());
  const std::string_view check = next_line(bytes);
  if (check != text_hash(bytes)) refuse("is damaged: its check sum is wrong");
  const std::string_view other = difference(bytes, origin);
  if (!other.empty()) refuse(fmt::format("belongs to {}", other));
  bytes.remove_prefix(origin.size());
  Checkpoint checkpoint;
  try {
    ArchiveReader reader(bytes);
    transfer_checkpoint(reader, checkpoint);
    if (!reader.at_end()) refuse("is damaged: it is longer than it should be");
  } catch (const RestartError& error) {
    refuse(fmt::format("is damaged: {}", error.what()));
  }
  return checkpoint;
}

Checkpoint read_checkpoint(const std::string& path, const std::string& origin) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw UsageError(fmt::format("--resume: there is no {}", path));
  return parse_checkpoint(file_bytes(file, magic), path, origin);
}

}  // namespace wuerfel
