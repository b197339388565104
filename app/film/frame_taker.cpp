#include "app/film/frame_taker.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <span>

#include "render/picture/body_color.h"

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

/// By this share of an average times of frames and of looks may differ that are one.
constexpr double rounding = 1e-6;

/// When the k-th look before a frame is; the 0-th is the frame itself. To the bit when the earlier frames of its film are,
/// where a whole number of them make a second: at the end of a step forces may hang on rounding.
double look_time(double frame, double average, int k) {
  const double looks_per_second = parts_of_average * std::round(1.0 / average);
  const double number = std::round(frame * looks_per_second);
  const double close = rounding * average;
  const bool of_film = std::abs(1.0 - looks_per_second * average / parts_of_average) < rounding
                       && std::abs(frame - number / looks_per_second) < close;
  return of_film ? (number - k) / looks_per_second : frame - average * k / parts_of_average;
}

/// How many looks the loads of a frame are averaged over.
int load_looks(const LookBack& back) {
  return static_cast<int>(std::lround(back.loads / back.average * parts_of_average));
}

/// Sums of joints, one for each pair of bodies; geometry is that of the latest look. What else is possible is known of the
/// frame alone: whether an earlier look was a frame of its own is not to be seen.
class JointSum {
 public:
  void add(std::span<const SnapshotJoint> joints, double share, bool of_frame) {
    for (SnapshotJoint joint : joints) {
      joint.force *= share;
      if (!of_frame) {
        joint.unique = true;
        joint.range.reset();
      }
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
    sum = more;
    sum.force = force;
    sum.point = point;
  }

  std::map<std::pair<int, int>, std::size_t> number_;
  std::vector<SnapshotJoint> sum_;
};

}  // namespace

std::vector<TimetableEntry> with_looks(std::vector<TimetableEntry> instants, const LookBack& back) {
  if (!(back.average > 0.0)) return instants;
  const double same = rounding * back.average;
  std::vector<TimetableEntry> looks;
  for (const TimetableEntry& instant : instants) {
    if (!instant.frame || instant.bare) continue;
    const int most =
        instant.sample ? std::max(parts_of_average, load_looks(back) - 1) : parts_of_average;
    for (int k = 1; k <= most; ++k) {
      const double t = look_time(instant.t, back.average, k);
      // Nearly the same instant will do where many are averaged.
      const double close = k > parts_of_average ? same : 0.0;
      const auto there = std::ranges::lower_bound(instants, t - close, {}, &TimetableEntry::t);
      if (there->t <= t + close) {
        there->look = true;
      } else if (t > -same) {
        looks.push_back({.t = std::max(t, 0.0), .look = true});
      }
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

/// The nearest; nothing where nobody looked.
const FrameTaker::Look* FrameTaker::look_at(double t, double close) const {
  const auto look =
      std::ranges::min_element(looks_, {}, [&](const Look& of) { return std::abs(of.t - t); });
  return look == looks_.end() || std::abs(look->t - t) >= close ? nullptr : &*look;
}

std::vector<SnapshotJoint> FrameTaker::averaged(const Snapshot& snapshot) const {
  std::vector<std::pair<const Joints*, double>> own;  // with their weights, the oldest first
  double total = 0.0;
  for (int k = parts_of_average; k >= 0; --k) {
    const Look* look =
        look_at(look_time(snapshot.time, back_.average, k), rounding * back_.average);
    if (look == nullptr || !look->joints) continue;
    own.emplace_back(look->joints.get(), k == 0 || k == parts_of_average ? 0.5 : 1.0);
    total += own.back().second;
  }
  const auto is_new = [&](const auto& look) {
    return look.first != own.front().first && *look.first != *own.front().first;
  };
  const bool steady = std::ranges::none_of(own, is_new);
  if (own.size() < 2 || (steady && impacts_.empty())) return snapshot.joints;
  JointSum sum;
  for (const auto& [joints, weight] : own)
    sum.add(*joints, weight / total, joints == own.back().first);
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
  for (const Event& impact : impacts_) {
    if (impact.t > t - back_.impacts)
      marks.push_back({impact.point, impact.impulse, (t - impact.t) / back_.impacts});
  }
  return marks;
}

/// In a crowd loads change from frame to frame; colours tell what a cube bears for a moment.
std::vector<double> FrameTaker::averaged_loads(double t) const {
  Loads sum;
  int count = 0;
  for (int k = 0; k < load_looks(back_); ++k) {
    // Looks of other frames, whose times are as good as these.
    const double close = 0.1 * back_.average / parts_of_average;
    const Look* look = look_at(look_time(t, back_.average, k), close);
    if (look == nullptr) continue;
    sum.resize(look->loads->size(), 0.0);
    std::ranges::transform(sum, *look->loads, sum.begin(), std::plus());
    ++count;
  }
  for (double& load : sum)
    load /= count;
  return sum;
}

/// What has not moved looks as it did, but for the time.
const FrameTaker::Seen& FrameTaker::see(const Simulation& simulation,
                                        const Moment& moment,
                                        const SnapshotRequest& request) {
  if (moment.loaded != last_.loaded || moment.state != last_.state) seen_.clear();
  last_ = moment;
  const auto seen = std::ranges::find(seen_, request, &Seen::request);
  if (seen != seen_.end()) return *seen;
  auto snapshot = std::make_shared<const Snapshot>(simulation.snapshot(moment, request));
  auto loads =
      back_.loads > 0.0 ? std::make_shared<const Loads>(wuerfel::loads(*snapshot)) : nullptr;
  return seen_.emplace_back(Seen{request, std::move(snapshot), std::move(loads)});
}

void FrameTaker::remember(double t, const Seen& seen) {
  looks_.push_back({t, {seen.snapshot, &seen.snapshot->joints}, seen.loads});
}

/// What no frame from t on looks back to.
void FrameTaker::forget(double t) {
  const auto is_over = [&](const Look& look, double memory) {
    return look.t < t - memory * (1.0 + rounding);
  };
  while (!looks_.empty() && is_over(looks_.front(), std::max(back_.average, back_.loads)))
    looks_.pop_front();
  for (Look& look : looks_) {
    if (!is_over(look, back_.average)) break;
    look.joints = nullptr;
  }
}

std::optional<Snapshot> FrameTaker::take(const Simulation& simulation,
                                         const Moment& moment,
                                         const TimetableEntry& instant) {
  notice_impacts(simulation.events(), moment.t);
  forget(instant.t);
  const SnapshotRequest request = instant.sample ? request_
                                  : instant.bare ? SnapshotRequest{}
                                                 : passing_;
  const bool averages = request_.joints && back_.average > 0.0;
  if (averages && instant.look && !(instant.frame && request.joints))
    remember(instant.t, see(simulation, moment, {.joints = true}));
  if (!instant.frame) return std::nullopt;
  const Seen& seen = see(simulation, moment, request);
  Snapshot snapshot = *seen.snapshot;
  snapshot.time = moment.t;
  if (averages && request.joints) {
    remember(instant.t, seen);
    snapshot.joints = averaged(snapshot);
    if (back_.loads > 0.0) snapshot.loads = averaged_loads(instant.t);
  }
  if (back_.impacts > 0.0) snapshot.impacts = marks(instant.t);
  return snapshot;
}

}  // namespace wuerfel
