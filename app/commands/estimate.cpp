#include "app/commands/estimate.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>

#include <fmt/core.h>

#include "app/cli/argument.h"
#include "app/cli/exit_code.h"

namespace wuerfel {

namespace {

constexpr int many_frames = 10000;
constexpr double much = 1e9;  // bytes

/// Bytes of something in a frame: nobody knows them before it is drawn.
struct Bytes {
  double least = 0.0;
  double likely = 0.0;
};

Bytes operator*(double times, const Bytes& bytes) {
  return {times * bytes.least, times * bytes.likely};
}

// Per pixel, by the shipped scenes at 1280 x 720: a PNG holds what is flat in few bytes, a film only
// what changes.
constexpr Bytes png_pixel{0.04, 0.1};
constexpr Bytes film_pixel{0.0003, 0.002};
// Per body in the tables: numbers with as many digits as they need.
constexpr Bytes table_row{30.0, 150.0};

struct Need {
  std::filesystem::path folder;
  Bytes bytes;
};

std::vector<Need> needs(const RunOptions& asked, const Scene& scene, double frames) {
  std::vector<Need> list;
  const auto add = [&](const std::string& name, const Bytes& bytes) {
    if (name.empty() || name == "-") return;
    std::error_code error;
    std::filesystem::path folder = std::filesystem::absolute(name, error);
    while (!std::filesystem::is_directory(folder, error) && folder.has_relative_path())
      folder = folder.parent_path();
    list.push_back({std::move(folder), bytes});
  };
  const auto& size = asked.picture.size;
  for (const std::string& name : asked.outputs) {
    const bool whole = name.ends_with('/') || has_suffix(name, ".apng");
    add(name, frames * size.width * size.height * (whole ? png_pixel : film_pixel));
  }
  const auto bodies = static_cast<double>(scene.cubes.size() + scene.points.size());
  add(asked.states, frames * bodies * table_row);
  add(asked.forces, frames * bodies * 2.0 * table_row);
  return list;
}

std::string size_text(double bytes) {
  if (bytes >= 1e9) return fmt::format("{:.3g} GB", bytes / 1e9);
  return bytes >= 1e6 ? fmt::format("{:.0f} MB", bytes / 1e6)
                      : fmt::format("{:.0f} kB", bytes / 1e3);
}

/// Throws UsageError where a disk is far too small. Folders of one disk share what is free.
void require_room(const std::vector<Need>& list) {
  std::map<std::uintmax_t, Need> disks;  // by what they have free
  for (const Need& need : list) {
    std::error_code error;
    const auto space = std::filesystem::space(need.folder, error);
    if (error) continue;
    Need& disk = disks[space.available];
    disk.folder = need.folder;
    disk.bytes.least += need.bytes.least;
  }
  for (const auto& [free, need] : disks) {
    if (need.bytes.least <= static_cast<double>(free)) continue;
    throw UsageError(fmt::format(
        "the outputs would take {} or more, {} has {} free; ask for less (--until, --fps, --size) "
        "or "
        "another folder",
        size_text(need.bytes.least), need.folder.string(), size_text(static_cast<double>(free))));
  }
}

}  // namespace

std::string estimate(const RunOptions& asked,
                     const Scene& scene,
                     const std::vector<TimetableEntry>& instants) {
  const auto frames = std::ranges::count(instants, true, &TimetableEntry::frame);
  const std::vector<Need> list = needs(asked, scene, static_cast<double>(frames));
  require_room(list);
  double bytes = 0.0;
  for (const Need& need : list)
    bytes += need.bytes.likely;
  if (frames < many_frames && bytes < much) return {};
  return fmt::format("{} frames, about {} on disk", frames, size_text(bytes));
}

}  // namespace wuerfel
