#include "core/time/shown_causes.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/geometry/box.h"

namespace wuerfel {
namespace {

/// A cube that moves by less than this share of the largest stands.
constexpr double no_part_in_it = 1e-6;

/// How far the corner that moves most does.
double reach(const StillScene& still, int cube, const Twist& motion) {
  const BodyState& at = still.state[cube];
  const Box box = make_box(at.position, at.angle, still.system.body(cube).size);
  double most = 0.0;
  for (const Vec2& arm : box.arm)
    most = std::max(most, point_velocity(motion, arm).norm());
  return most;
}

bool is_box(const StillScene& still, int body) {
  return still.system.body(body).kind == BodyKind::cube;
}

}  // namespace

StillScene held_still(const System& system,
                      const MotionSettings& settings,
                      const State& state,
                      std::span<const Contact> loaded) {
  StillScene still{system, state, {}, Verdict::undecided};
  for (BodyState& s : still.state)
    stop(s);
  still.found = ForceFinder(system, settings).at(still.state, Detail::accelerations, loaded);
  still.verdict = judge(system, still.state, still.found);
  return still;
}

SnapshotCause shown_cause(const StillScene& still, const Cause& cause) {
  SnapshotCause shown;
  for (const int body : cause.part.cubes)
    if (is_box(still, body)) shown.part.push_back(body);  // points have no box in a picture
  shown.centre = cause.part.centre;
  if (!cause.corner) return shown;
  const Vec2 down = still.down();
  shown.corner = cause.corner;
  shown.beside = cause.part.centre + down.dot(*cause.corner - cause.part.centre) * down;
  shown.outside = *cause.outside;
  return shown;
}

std::vector<SnapshotCause> shown_causes(const StillScene& still, const Causes& causes) {
  std::vector<SnapshotCause> shown;
  std::set<int> islands;
  for (const Cause& cause : causes.causes) {
    if (cause.island >= 0 && islands.insert(cause.island).second)
      shown.push_back(shown_cause(still, cause));
  }
  return shown;
}

void add_causes(const StillScene& still, const SnapshotRequest& request, Snapshot& snapshot) {
  const Causes causes = find_causes(still);
  if (request.causes) snapshot.causes = shown_causes(still, causes);
  if (request.mechanism) snapshot.mechanism = shown_motion(still, causes.certificate);
}

std::vector<SnapshotMotion> shown_motion(const StillScene& still, const Certificate& certificate) {
  std::vector<SnapshotMotion> shown;
  std::vector<double> reaches;
  double largest = 0.0;
  for (int cube = 0; cube < std::ssize(certificate.motion); ++cube) {
    const bool takes_part = is_box(still, cube) && still.island_of(cube) >= 0;
    reaches.push_back(takes_part ? reach(still, cube, certificate.motion[cube]) : 0.0);
    largest = std::max(largest, reaches.back());
  }
  for (int cube = 0; cube < std::ssize(certificate.motion); ++cube) {
    if (reaches[cube] <= no_part_in_it * largest) continue;
    const Twist& motion = certificate.motion[cube];
    shown.push_back({cube, motion.linear / largest, motion.angular / largest});
  }
  return shown;
}

}  // namespace wuerfel
