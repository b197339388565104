#include "core/scene/truss.h"

#include <fmt/format.h>

namespace wuerfel {
namespace {

/// Where the upper chord of a truss has its joints: over those of the lower but its ends, or over the middles of bays.
bool has_posts(const TrussEntry& truss) { return truss.kind != TrussKind::warren; }
std::int64_t upper_joints(const TrussEntry& truss) {
  return has_posts(truss) ? truss.count - 1 : truss.count;
}

/// Adds joints of one truss.
class TrussRods {
 public:
  TrussRods(const TrussEntry& truss, const std::string& name, JointEntries& joints)
      : truss_(truss), name_(name), joints_(joints) {}

  void add_chords() {
    for (std::int64_t i = 1; i <= truss_.count; ++i)
      add("bottom", i, joint('b', i - 1), joint('b', i));
    for (std::int64_t i = 1; i < upper_joints(truss_); ++i)
      add("top", i, joint('t', i), joint('t', i + 1));
  }

  void add_triangles() {
    for (std::int64_t i = 1; i <= truss_.count; ++i) {
      add("diagonal", 2 * i - 1, joint('b', i - 1), joint('t', i));
      add("diagonal", 2 * i, joint('t', i), joint('b', i));
    }
  }

  /// Posts, and one diagonal in each bay; those of the end bays rise from the supports.
  void add_posts() {
    const std::int64_t n = truss_.count;
    for (std::int64_t i = 1; i < n; ++i)
      add("post", i, joint('b', i), joint('t', i));
    for (std::int64_t i = 1; i <= n; ++i) {
      const bool left = 2 * i <= n;
      const bool rises = i == 1 || (i < n && left == (truss_.kind == TrussKind::howe));
      add("diagonal", i, joint(rises ? 'b' : 't', i - 1), joint(rises ? 't' : 'b', i));
    }
  }

  void add_supports() {
    if (truss_.supports == Supports::none) return;
    const std::string left = name_ + "_left";
    const std::string right = name_ + "_right";
    joints_.pins.push_back({truss_.origin, left, joint('b', 0), world(truss_.from), false});
    const PlaceEntry end = joint('b', truss_.count);
    if (truss_.supports == Supports::pins) {
      joints_.pins.push_back({truss_.origin, right, end, world(truss_.to), false});
    } else {
      const Vec2 down = -perp((truss_.to - truss_.from).normalized());
      const PlaceEntry foot = world(truss_.to + truss_.height * down);
      joints_.rods.push_back({truss_.origin, right, end, foot, std::nullopt});
    }
  }

 private:
  static PlaceEntry world(const Vec2& at) { return {"", false, at}; }
  [[nodiscard]] PlaceEntry joint(char chord, std::int64_t i) const {
    return {fmt::format("{}_{}{}", name_, chord, i), true, Vec2::Zero()};
  }
  void add(const char* part, std::int64_t i, const PlaceEntry& from, const PlaceEntry& to) {
    joints_.rods.push_back(
        {truss_.origin, fmt::format("{}_{}{}", name_, part, i), from, to, std::nullopt});
  }

  const TrussEntry& truss_;
  const std::string& name_;
  JointEntries& joints_;
};

}  // namespace

std::string truss_name(const std::vector<TrussEntry>& trusses, int i) {
  return trusses[i].name.value_or(fmt::format("truss{}", i + 1));
}

std::vector<ScenePoint> truss_points(const TrussEntry& truss,
                                     const std::string& name,
                                     const Material& material,
                                     const SceneSource& source) {
  const Vec2 span = truss.to - truss.from;
  if (span.isZero(0.0)) fail_at(source, truss.origin, "to", "must be another place than `from`");
  const Vec2 up = truss.height * perp(span.normalized());
  const auto at = [&](double bays) -> Vec2 {
    return truss.from + bays / static_cast<double>(truss.count) * span;
  };
  std::vector<ScenePoint> points;
  const auto add = [&](char chord, std::int64_t i, const Vec2& place) {
    points.push_back(
        {fmt::format("{}_{}{}", name, chord, i), truss.mass, place, Vec2::Zero(), material});
  };
  for (std::int64_t i = 0; i <= truss.count; ++i)
    add('b', i, i == truss.count ? truss.to : at(static_cast<double>(i)));
  for (std::int64_t i = 1; i <= upper_joints(truss); ++i)
    add('t', i, at(static_cast<double>(i) - (has_posts(truss) ? 0.0 : 0.5)) + up);
  return points;
}

void join_truss(const TrussEntry& truss, const std::string& name, JointEntries& joints) {
  TrussRods rods(truss, name, joints);
  rods.add_chords();
  has_posts(truss) ? rods.add_posts() : rods.add_triangles();
  rods.add_supports();
}

}  // namespace wuerfel
