#include "app/film/frame_taker.h"

#include <algorithm>
#include <functional>
#include <map>
#include <span>

namespace wuerfel {

namespace {

/// Bodies are numbered as in SnapshotJoint::other.
std::map<std::string, int> numbers_of(const Snapshot& snapshot) {
  std::map<std::string, int> numbers;
  for (const SnapshotBox& box : snapshot.boxes)
    numbers.emplace(box.name, static_cast<int>(numbers.size()));
  for (const SnapshotPlane& plane : snapshot.planes)
    numbers.emplace(plane.name, static_cast<int>(numbers.size()));
  return numbers;
}

bool is_same(const BodyState& a, const BodyState& b) {
  return a.position == b.position && a.angle == b.angle && a.velocity == b.velocity
         && a.spin == b.spin;
}

/// When the k-th look before a frame is; the 0-th is the frame itself.
double look_time(double frame, double average, int k) {
  return frame - average * k / looks_per_average;
}

/// Sums of joints, one for each pair of bodies; geometry is that of the latest look.
class JointSum {
 public:
  void add(std::span<const SnapshotJoint> joints, double share) {
    for (SnapshotJoint joint : joints) {
      joint.force *= share;
      const auto [entry, is_new] =
          number_.emplace(std::minmax(joint.body, joint.other), sum_.size());
      if (is_new) {
        sum_.push_back(joint);
      } else {
        merge(joint, sum_[entry->second]);
      }
    }
  }

  /// An impulse over the time of the average, along the normal of the joint that it came through;
  /// where the bodies had no other contact there is a mark and no arrow.
  void add_impulse(int on, int from, double force) {
    const auto found = number_.find(std::minmax(on, from));
    if (found == number_.end()) return;
    SnapshotJoint& joint = sum_[found->second];
    joint.force += force * joint.normal;
  }

  [[nodiscard]] const std::vector<SnapshotJoint>& joints() const { return sum_; }

 private:
  static void merge(const SnapshotJoint& more, SnapshotJoint& sum) {
    const double before = sum.force.norm();
    const double added = more.force.norm();
    const Vec2 force =
        more.body == sum.body ? Vec2(sum.force + more.force) : Vec2(more.force - sum.force);
    const Vec2 point = before + added > 0.0
                           ? Vec2((before * sum.point + added * more.point) / (before + added))
                           : more.point;
    const bool unique = sum.unique && more.unique;
    sum = more;
    sum.force = force;
    sum.point = point;
    sum.unique = unique;
  }

  std::map<std::pair<int, int>, std::size_t> number_;
  std::vector<SnapshotJoint> sum_;
};

}  // namespace

std::vector<Instant> with_looks(std::vector<Instant> instants, double average) {
  if (!(average > 0.0)) return instants;
  std::vector<Instant> looks;
  for (const Instant& instant : instants) {
    for (int k = 1; instant.frame && !instant.bare && k < looks_per_average; ++k) {
      const double t = look_time(instant.t, average, k);
      if (t > 0.0) looks.push_back({.t = t, .look = true});
    }
  }
  return merged(std::move(instants), looks);
}

/// Up to time t.
void FrameTaker::notice_impacts(const std::vector<Event>& events, double t) {
  for (; noticed_ < events.size() && events[noticed_].t <= t; ++noticed_)
    if (events[noticed_].impulse > 0.0) impacts_.push_back(events[noticed_]);
  const double oldest = t - std::max(back_.average, back_.impacts);
  while (!impacts_.empty() && impacts_.front().t < oldest)
    impacts_.pop_front();
}

std::vector<SnapshotJoint> FrameTaker::averaged(const Snapshot& snapshot) const {
  // Other frames may have had looks in between; these are those of this one, the oldest first.
  std::vector<const Joints*> own;
  for (int k = looks_per_average - 1; k >= 0; --k) {
    const double t = look_time(snapshot.time, back_.average, k);
    const auto look = std::ranges::find(looks_, t, &Look::t);
    if (look != looks_.end()) own.push_back(look->joints.get());
  }
  const auto same = [](const Joints* a, const Joints* b) { return a == b || *a == *b; };
  const bool steady = std::ranges::adjacent_find(own, std::not_fn(same)) == own.end();
  if (own.size() < 2 || (steady && impacts_.empty())) return snapshot.joints;
  JointSum sum;
  for (const Joints* joints : own)
    sum.add(*joints, 1.0 / static_cast<double>(own.size()));
  const std::map<std::string, int> number =
      impacts_.empty() ? std::map<std::string, int>{} : numbers_of(snapshot);
  for (const Event& impact : impacts_) {
    if (impact.t <= snapshot.time - back_.average) continue;
    // Point masses have no faces.
    const auto on = number.find(impact.on);
    const auto from = number.find(impact.from);
    if (on != number.end() && from != number.end())
      sum.add_impulse(on->second, from->second, impact.impulse / back_.average);
  }
  return sum.joints();
}

std::vector<SnapshotImpact> FrameTaker::marks(double t) const {
  std::vector<SnapshotImpact> marks;
  for (const Event& impact : impacts_)
    if (impact.t > t - back_.impacts)
      marks.push_back({impact.point, impact.impulse, (t - impact.t) / back_.impacts});
  return marks;
}

/// What has not moved looks as it did, but for the time.
std::shared_ptr<const Snapshot> FrameTaker::snapshot(const Simulation& simulation,
                                                     const Moment& moment,
                                                     const SnapshotRequest& request) {
  if (moment.loaded != last_.loaded || !std::ranges::equal(moment.state, last_.state, is_same))
    seen_.clear();
  last_ = moment;
  const auto seen = std::ranges::find(seen_, request, &Seen::request);
  if (seen != seen_.end()) return seen->snapshot;
  seen_.push_back(
      {request, std::make_shared<const Snapshot>(simulation.snapshot(moment, request))});
  return seen_.back().snapshot;
}

std::optional<Snapshot> FrameTaker::take(const Simulation& simulation,
                                         const Moment& moment,
                                         const Instant& instant) {
  notice_impacts(simulation.events(), moment.t);
  while (!looks_.empty() && looks_.front().t <= instant.t - back_.average * (1.0 - 1e-9))
    looks_.pop_front();
  const auto remember = [&](std::shared_ptr<const Snapshot> of) {
    const Joints* joints = &of->joints;
    looks_.push_back({instant.t, {std::move(of), joints}});
  };
  if (!instant.frame) {
    if (instant.look && request_.joints)
      remember(this->snapshot(simulation, moment, {.joints = true}));
    return std::nullopt;
  }
  const SnapshotRequest request = instant.sample ? request_
                                  : instant.bare ? SnapshotRequest{}
                                                 : passing_;
  const std::shared_ptr<const Snapshot> seen = this->snapshot(simulation, moment, request);
  Snapshot snapshot = *seen;
  snapshot.time = moment.t;
  if (request.joints && back_.average > 0.0) {
    remember(seen);
    snapshot.joints = averaged(snapshot);
  }
  if (back_.impacts > 0.0) snapshot.impacts = marks(instant.t);
  return snapshot;
}

}  // namespace wuerfel
