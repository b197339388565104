#include "app/run_plan.h"

#include <algorithm>
#include <string_view>

#include <fmt/core.h>

#include "app/picture_options.h"
#include "core/scene/suggestion.h"

namespace wuerfel {

namespace {

constexpr double most_frames = 1e7;  // more would fill memory and disk long before they are of use

void require_samples_until(double end, const std::vector<double>& samples) {
  for (const double t : samples) {
    if (t <= end) continue;
    throw UsageError(fmt::format("--sample: {} s is after the end of the run at {} s", t, end));
  }
}

std::vector<double> frames_until(double end, const RunOptions& options) {
  const bool wanted =
      !options.outputs.empty() || !options.states.empty() || !options.forces.empty();
  if (!wanted) return {};
  const double count = end * options.rate.fps / options.rate.speed;
  if (count > most_frames) {
    throw UsageError(fmt::format("{:.3g} frames are more than {:.0f}", count, most_frames));
  }
  return frame_times(end, options.rate);
}

// A camera has to find the body that it follows.
void require_body(const Camera& camera, const Scene& scene) {
  if (camera.kind != Camera::Kind::follow) return;
  std::vector<std::string_view> names;
  for (const SceneCube& cube : scene.cubes)
    names.push_back(cube.name);
  if (std::ranges::find(names, camera.body) != names.end()) return;
  throw UsageError(
      fmt::format("--view: there is no cube '{}'{}", camera.body, suggestion(camera.body, names)));
}

}  // namespace

RunPlan make_plan(const RunOptions& options, const Scene& scene) {
  RunPlan plan;
  plan.end = options.until.value_or(scene.duration);
  require_samples_until(plan.end, options.samples);
  require_body(options.picture.camera, scene);
  plan.instants = timetable(plan.end, frames_until(plan.end, options), options.samples);
  if (!options.outputs.empty()) plan.request = snapshot_request(options.picture.layers);
  if (!options.forces.empty()) plan.request.forces = true;
  return plan;
}

}  // namespace wuerfel
