#include "app/commands/run_plan.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include <fmt/core.h>

#include "app/cli/exit_code.h"
#include "app/cli/is_folder.h"
#include "app/cli/places.h"
#include "app/cli/scene_source.h"

namespace wuerfel {

namespace {

void require_samples_until(double end, const std::vector<double>& samples) {
  for (const double t : samples) {
    if (t <= end) continue;
    throw UsageError(fmt::format("--sample: {} s is after the end of the run at {} s", t, end));
  }
}

bool has_frames(const RunOptions& asked) { return !asked.outputs.empty() || asked.tables(); }

// Where nobody looks, somebody waits: he sees every hundredth of the way, or every checkpoint.
std::vector<double> marks_until(double end, const RunOptions& asked) {
  constexpr double most = 1e6;
  const double wanted = asked.every ? std::ceil(end / *asked.every) : 0.0;
  const int count = static_cast<int>(std::clamp(wanted, 100.0, most));
  std::vector<double> marks;
  for (int k = 1; k < count; ++k)
    marks.push_back(end * k / count);
  return marks;
}

// A camera has to find the body that it follows.
void require_body(const Camera& camera, const Scene& scene) {
  if (camera.kind != Camera::Kind::follow) return;
  static_cast<void>(moving_number(scene, "--view", camera.body));
}

}  // namespace

std::vector<std::string> RunOptions::files() const {
  std::vector<std::string> names = outputs;
  for (const std::string* file :
       {&states, &forces, &events, &summary, &failed_programs, &checkpoint})
    if (!file->empty()) names.push_back(*file);
  return names;
}

void require_distinct_outputs(const RunOptions& asked) {
  std::map<std::filesystem::path, std::string> taken;
  if (asked.json) taken["-"] = "--json";
  for (const std::string& name : asked.files()) {
    // A folder is none, but may have the name of a shipped scene.
    for (const std::string& scene : asked.scenes)
      if (!is_folder(scene)) require_kept(scene, name);
    const auto place = place_of(name);
    if (place && !taken.emplace(*place, name).second) {
      throw UsageError(name == "-" ? "only one of --json and the files can be standard output"
                                   : fmt::format("two outputs have the name {}", name));
    }
  }
}

RunPlan make_plan(const RunOptions& asked, const Scene& scene) {
  RunPlan plan;
  plan.end = asked.until.value_or(scene.duration);
  require_samples_until(plan.end, asked.samples);
  require_possible_steps(plan.end, asked.motion);
  require_body(asked.picture.camera, scene);
  if (has_frames(asked)) static_cast<void>(frame_count(plan.end, asked.rate));
  if (asked.hold) static_cast<void>(frame_count(*asked.hold, {asked.rate.fps, 1.0}));
  if (!asked.outputs.empty()) {
    PictureOptions picture = asked.picture;
    picture.color_by = color_by(picture, scene.cubes.size());
    plan.request = snapshot_request(picture, scene.cubes.size());
    plan.back = look_back(picture, asked.rate.speed / asked.rate.fps, asked.rate.speed);
  }
  if (!asked.forces.empty()) plan.request.forces = true;
  return plan;
}

std::vector<TimetableEntry> instants_of(const RunOptions& asked, const RunPlan& plan) {
  using Times = std::vector<double>;
  const bool frames = has_frames(asked);
  std::vector<TimetableEntry> instants =
      timetable(plan.end, frames ? frame_times(plan.end, asked.rate) : Times{}, asked.samples,
                frames ? Times{} : marks_until(plan.end, asked));
  mark_scales(instants);
  return with_looks(std::move(instants), plan.back);
}

}  // namespace wuerfel
