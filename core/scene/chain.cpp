#include "core/scene/chain.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

#include "core/geometry/box.h"
#include "core/geometry/trig.h"
#include "core/scene/place_finder.h"

namespace wuerfel {
namespace {

/// Share of the distance of its ends by which a chain may be longer or shorter and yet be straight.
constexpr double straight_share = 1e-12;

/// Angles at the centre, halved, of chords s on a circle of the curvature 2 c.
double half_angle(double s, double c) {
  const double sine = std::min(1.0, s * c);
  return wuerfel::atan2(sine, std::sqrt((1.0 - sine) * (1.0 + sine)));
}

double whole_half_angle(const std::vector<double>& segments, double c) {
  const auto add = [c](double sum, double s) { return sum + half_angle(s, c); };
  return std::accumulate(segments.begin(), segments.end(), 0.0, add);
}

/// Corners of the segments on an arc that is symmetric about its middle.
std::vector<Vec2> corners_at(const std::vector<double>& segments, double c) {
  double angle = whole_half_angle(segments, c);  // of the direction, against the x axis
  std::vector<Vec2> corners = {Vec2::Zero()};
  for (const double s : segments) {
    const double half = half_angle(s, c);
    Vec2 along;
    sin_cos(angle - half, along.y(), along.x());
    corners.emplace_back(corners.back() + s * along);
    angle -= 2.0 * half;
  }
  return corners;
}

/// One chain while it is laid.
class Chain {
 public:
  Chain(const ChainGround& ground, const ChainEntry& entry, std::string name)
      : ground_(ground), entry_(entry), name_(std::move(name)) {}

  void lay() {
    const FoundPlace from = end("from", entry_.from);
    const FoundPlace to = end("to", entry_.to);
    measure(from, to);
    const std::vector<Vec2> corners = corners_of(from.world, to.world);
    const int step = has_rods() ? 2 : 1;  // segments a link
    for (int i = 0; i < entry_.count; ++i) {
      if (entry_.link) {
        const int left = has_rods() ? step * i + 1 : i;
        place_cube(i, corners[left], corners[left + 1]);
      } else {
        ground_.scene.points[body(i).index].position = corners[i + 1];
      }
    }
  }

  void join(JointEntries& joints) const {
    const int last =
        entry_.loose ? static_cast<int>(entry_.count) - 1 : static_cast<int>(entry_.count);
    for (int i = 0; i <= last; ++i) {
      const PlaceEntry from = i == 0 ? entry_.from : side(i - 1, 0.5);
      const PlaceEntry to = i == entry_.count ? entry_.to : side(i, -0.5);
      if (has_rods()) {
        joints.rods.push_back(
            {entry_.origin, fmt::format("{}_rod{}", name_, i + 1), from, to, std::nullopt});
      } else {
        joints.pins.push_back(
            {entry_.origin, fmt::format("{}_pin{}", name_, i + 1), from, to, false});
      }
    }
  }

 private:
  [[noreturn]] void fail(std::string_view key, const std::string& message) const {
    fail_at(ground_.source, entry_.origin, key, message);
  }

  [[nodiscard]] BodyRef body(int link) const {
    return ground_.names.at(fmt::format("{}_{}", name_, link + 1));
  }

  /// A place that does not wait for this chain or what comes later.
  [[nodiscard]] FoundPlace end(std::string_view key, const PlaceEntry& entry) const {
    FoundPlace found =
        PlaceFinder(ground_.scene, ground_.names, ground_.source).find(entry, entry_.origin, key);
    if (!found.body) return found;
    const Group& group = ground_.groups.of(*found.body);
    const bool later =
        group.placed_by == PlacedBy::pile
        || (group.placed_by == PlacedBy::chain && group.origin->table >= entry_.origin.table);
    if (later) {
      fail(key,
           fmt::format("\"{}\" has no place yet when \"{}\" is laid: chains are laid one after "
                       "the other, piles scattered last",
                       found.place.body, name_));
    }
    return found;
  }

  /// Lengths of its rods.
  void measure(const FoundPlace& from, const FoundPlace& to) {
    const double distance = (from.world - to.world).norm();
    length_ = entry_.length.value_or(distance);
    const double slack = length_ - distance;
    if (slack < -straight_share * distance) {
      fail("length",
           fmt::format("must be at least the distance of its ends, {:.6g} m; it is {:.6g} m",
                       distance, length_));
    }
    straight_ = slack <= straight_share * distance;
    if (straight_ && !entry_.loose && !from.moves() && !to.moves()) {
      fail("to", fmt::format("\"{0}\" would be taut between two places that cannot move; give it a "
                             "length above {1:.6g} m, or loose = true",
                             name_, distance));
    }
    const double links = static_cast<double>(entry_.count);
    const double along = entry_.link ? links * entry_.link->extent.x() : 0.0;
    const double least = entry_.link ? touching_tolerance * entry_.link->extent.minCoeff() : 0.0;
    if (along - length_ > least) {
      fail("size", fmt::format("{} links of {:.6g} m are longer than the chain, {:.6g} m",
                               entry_.count, entry_.link->extent.x(), length_));
    }
    const double left = length_ - along;
    rod_ = left > least ? left / (entry_.loose ? links : links + 1.0) : 0.0;
    if (!has_rods() && !entry_.link) fail("to", "must be another place than `from`");
  }

  [[nodiscard]] bool has_rods() const { return rod_ > 0.0; }

  [[nodiscard]] std::vector<double> segments() const {
    std::vector<double> list;
    for (int i = 0; i < entry_.count; ++i) {
      if (has_rods()) list.push_back(rod_);
      if (entry_.link) list.push_back(entry_.link->extent.x());
    }
    if (has_rods() && !entry_.loose) list.push_back(rod_);
    return list;
  }

  [[nodiscard]] std::vector<Vec2> corners_of(const Vec2& from, const Vec2& to) const {
    const double distance = (to - from).norm();
    std::vector<Vec2> corners =
        straight_ ? corners_at(segments(), 0.0) : corners_on_arc(segments(), distance);
    if (corners.empty()) {
      fail("length", fmt::format("a chain of {:.6g} m between places {:.6g} m apart finds no place "
                                 "on an arc with links of this size; make them smaller",
                                 length_, distance));
    }
    const Vec2 along = distance > 0.0 ? Vec2((to - from) / distance) : Vec2::UnitX();
    const Vec2 left = perp(along);
    const Vec2 sag = ground_.scene.gravity.dot(left) > 0.0 ? left : Vec2(-left);
    for (Vec2& corner : corners)
      corner = from + corner.x() * along + corner.y() * sag;
    return corners;
  }

  void place_cube(int link, const Vec2& left, const Vec2& right) const {
    SceneCube& cube = ground_.scene.cubes[body(link).index];
    cube.position = 0.5 * (left + right);
    const Vec2 along = right - left;
    cube.angle = wuerfel::atan2(along.y(), along.x());
  }

  /// The end of a link, in its lengths from the centre.
  [[nodiscard]] PlaceEntry side(int link, double at) const {
    const double length = entry_.link ? entry_.link->extent.x() : 0.0;
    return {fmt::format("{}_{}", name_, link + 1), true, {at * length, 0.0}};
  }

  const ChainGround& ground_;
  const ChainEntry& entry_;
  std::string name_;
  double length_ = 0.0;    ///< m
  double rod_ = 0.0;       ///< m, each of its rods; 0: pins
  bool straight_ = false;  ///< whether it does not sag
};

}  // namespace

std::string chain_name(const std::vector<ChainEntry>& chains, int i) {
  return chains[i].name.value_or(fmt::format("chain{}", i + 1));
}

std::vector<ScenePoint> chain_points(const ChainEntry& chain,
                                     const std::string& name,
                                     const Material& material) {
  std::vector<ScenePoint> points;
  for (std::int64_t i = 1; i <= chain.count; ++i) {
    points.push_back(
        {fmt::format("{}_{}", name, i), chain.mass, Vec2::Zero(), Vec2::Zero(), material});
  }
  return points;
}

void lay_chains(const ChainGround& ground,
                const std::vector<ChainEntry>& chains,
                JointEntries& joints) {
  for (int i = 0; i < static_cast<int>(chains.size()); ++i) {
    Chain chain(ground, chains[i], chain_name(chains, i));
    chain.lay();
    chain.join(joints);
  }
}

std::vector<Vec2> corners_on_arc(const std::vector<double>& segments, double distance) {
  // The chord shrinks as the arc is bent.
  double low = 0.0;
  double high = 1.0 / *std::ranges::max_element(segments);
  const auto too_long = [&](double c) {
    return whole_half_angle(segments, c) < std::numbers::pi
           && corners_at(segments, c).back().x() > distance;
  };
  if (too_long(high)) return {};
  while (true) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) return corners_at(segments, low);
    (too_long(middle) ? low : high) = middle;
  }
}

}  // namespace wuerfel
