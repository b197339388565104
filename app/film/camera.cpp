#include "app/film/camera.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/core.h>

#include "app/cli/exit_code.h"
#include "app/cli/options.h"
#include "app/cli/picture_values.h"
#include "core/scene/suggestion.h"

namespace wuerfel {

namespace {

constexpr std::string_view follow_prefix = "follow:";
constexpr double sides_around = 14.0;  // of a followed body, from left to right

/// Where a body is, and its size; points take that of a metre.
struct Followed {
  Vec2 center;
  double side = 1.0;  ///< m
};

Followed find_body(const std::string& name, const Snapshot& snapshot) {
  const auto found = std::ranges::find(snapshot.boxes, name, &SnapshotBox::name);
  if (found != snapshot.boxes.end())
    return {found->center, std::sqrt(found->size.x() * found->size.y())};
  const auto mass = std::ranges::find(snapshot.masses, name, &SnapshotMass::name);
  if (mass != snapshot.masses.end()) return {mass->position, 1.0};
  throw UsageError(fmt::format("--view: there is no body '{}'{}", name,
                               suggestion(name, snapshot.boxes, &SnapshotBox::name)));
}

}  // namespace

Camera parse_camera(std::string_view text) {
  Camera camera;
  if (text == "fit") return camera;
  if (text.starts_with(follow_prefix)) {
    camera.kind = Camera::Kind::follow;
    camera.body = text.substr(follow_prefix.size());
    return camera;
  }
  const WorldWindow window = parse_window(text);
  camera.kind = Camera::Kind::fixed;
  camera.center = window.center;
  camera.width = window.width;
  return camera;
}

std::string option_text(const Camera& camera) {
  const std::string zoom = camera.zoom == 1.0 ? "" : fmt::format(" --zoom {}", camera.zoom);
  switch (camera.kind) {
    case Camera::Kind::fit:
      break;
    case Camera::Kind::fixed:
      return fmt::format("--view {},{},{}", camera.center.x(), camera.center.y(), camera.width)
             + zoom;
    case Camera::Kind::follow:
      return "--view " + quoted_word(fmt::format("{}{}", follow_prefix, camera.body)) + zoom;
  }
  return "--view fit" + zoom;
}

View camera_view(const Camera& camera, const Snapshot& snapshot, int width, int height) {
  if (camera.kind != Camera::Kind::follow)
    return fixed_view(camera.center, camera.width / camera.zoom, width, height);
  const Followed body = find_body(camera.body, snapshot);
  return fixed_view(body.center, sides_around * body.side / camera.zoom, width, height);
}

}  // namespace wuerfel
