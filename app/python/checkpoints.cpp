#include "app/python/checkpoints.h"

#include <fmt/format.h>

#include "app/cli/exit_code.h"
#include "app/cli/scene_source.h"
#include "core/time/archive.h"
#include "core/time/restart_point.h"

namespace wuerfel::python {

namespace {

constexpr std::string_view magic = "wuerfel simulation\n";

template <class Archive>
void transfer_record(Archive& archive, SimulationRecord& record) {
  archive(record.scene);
  archive(record.motion.integrator);
  archive(record.motion.formulation);
  archive(record.motion.solver);
  archive(record.motion.tolerance);
  archive(record.motion.step);
  archive(record.t);
  archive(record.restart_point);
}

[[noreturn]] void refuse(std::string_view why) {
  throw UsageError(fmt::format("checkpoint: the bytes {}", why));
}

std::string_view next_line(std::string_view& bytes) {
  const std::size_t end = bytes.find('\n');
  const std::string_view line = bytes.substr(0, end);
  bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + 1);
  return line;
}

}  // namespace

void RestartPoints::note(std::string point, std::size_t cubes) {
  const double t = restart_point_of(point, cubes).t;
  if (t <= goal_) points_.clear();
  points_.emplace_back(t, std::move(point));
}

const std::string& RestartPoints::before(double t) const {
  static const std::string start;
  const std::string* last = &start;
  for (const auto& [when, point] : points_)
    if (when <= t) last = &point;
  return *last;
}

std::string to_bytes(SimulationRecord record) {
  ArchiveWriter writer;
  transfer_record(writer, record);
  return fmt::format("{}{}\n{}\n{}", magic, WUERFEL_VERSION, text_hash(writer.bytes()),
                     writer.bytes());
}

SimulationRecord record_of(std::string_view bytes) {
  if (!bytes.starts_with(magic)) refuse("are no checkpoint of a simulation");
  bytes.remove_prefix(magic.size());
  if (const std::string_view version = next_line(bytes); version != WUERFEL_VERSION)
    refuse(fmt::format("are of wuerfel {}, this is {}", version, WUERFEL_VERSION));
  const std::string_view sum = next_line(bytes);
  if (sum != text_hash(bytes)) refuse("are damaged: their check sum is wrong");
  SimulationRecord record;
  ArchiveReader reader(bytes);
  transfer_record(reader, record);
  return record;
}

}  // namespace wuerfel::python
