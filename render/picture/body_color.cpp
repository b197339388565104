#include "render/picture/body_color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace wuerfel {
namespace {

constexpr std::array<std::string_view, 4> names{"body", "load", "speed", "island"};

/// Ten even steps of viridis, from 0.1 to 1.
constexpr std::array<Color, 10> viridis{rgb(0x482475), rgb(0x414487), rgb(0x355F8D), rgb(0x2A788E),
                                        rgb(0x21918C), rgb(0x22A884), rgb(0x44BF70), rgb(0x7AD151),
                                        rgb(0xBDDF26), rgb(0xFDE725)};

std::vector<double> speeds(const Snapshot& snapshot) {
  std::vector<double> values;
  for (const SnapshotBox& box : snapshot.boxes)
    values.push_back(box.velocity.norm());
  return values;
}

std::vector<double> values_of(const Snapshot& snapshot, ColorBy by) {
  return by == ColorBy::load ? loads(snapshot) : speeds(snapshot);
}

double largest_of_cubes(const Snapshot& snapshot, const std::vector<double>& values) {
  double largest = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!snapshot.boxes[i].fixed) largest = std::max(largest, values[i]);
  return largest;
}

/// For each box the smallest number of a box in its island.
std::vector<int> islands(const Snapshot& snapshot) {
  std::vector<int> leader(snapshot.boxes.size());
  std::iota(leader.begin(), leader.end(), 0);
  const auto find = [&leader](int i) {
    while (leader[i] != i)
      i = leader[i] = leader[leader[i]];
    return i;
  };
  for (const SnapshotJoint& joint : snapshot.joints) {
    if (joint.other < 0 || joint.other >= std::ssize(snapshot.boxes)) continue;
    if (snapshot.boxes[joint.other].fixed || snapshot.boxes[joint.body].fixed) continue;
    const int a = find(joint.body);
    const int b = find(joint.other);
    leader[std::max(a, b)] = std::min(a, b);
  }
  for (int i = 0; i < std::ssize(leader); ++i)
    leader[i] = find(i);
  return leader;
}

std::vector<Color> island_colors(const Snapshot& snapshot, const Style& style) {
  const std::vector<int> leader = islands(snapshot);
  std::vector<Color> colors;
  for (std::size_t i = 0; i < leader.size(); ++i) {
    SnapshotBox box = snapshot.boxes[leader[i]];
    box.color.reset();
    box.fixed = snapshot.boxes[i].fixed;
    colors.push_back(body_color(style, box));
  }
  return colors;
}

}  // namespace

std::string_view to_string(ColorBy by) {
  const auto i = static_cast<std::size_t>(by);
  return i < names.size() ? names.at(i) : "?";
}

Color scale_color(const Style& style, double share) {
  const double within = std::clamp(share, 0.0, 1.0);
  if (style.theme == Theme::print) return mix(rgb(0xF6F6F6), rgb(0x8C8C8C), within);
  const double place = within * (viridis.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), viridis.size() - 2);
  return mix(viridis.at(below), viridis.at(below + 1), place - static_cast<double>(below));
}

std::vector<double> joint_loads(const Snapshot& snapshot) {
  std::vector<double> values(snapshot.boxes.size(), 0.0);
  for (const SnapshotJoint& joint : snapshot.joints)
    if (joint.body >= 0) values[joint.body] += joint.force.norm();
  return values;
}

std::vector<double> loads(const Snapshot& snapshot) {
  return snapshot.loads.empty() ? joint_loads(snapshot) : snapshot.loads;
}

double largest_value(const Snapshot& snapshot, ColorBy by) {
  if (by != ColorBy::load && by != ColorBy::speed) return 0.0;
  return largest_of_cubes(snapshot, values_of(snapshot, by));
}

std::vector<Color> body_colors(const Snapshot& snapshot,
                               const Style& style,
                               const BodyColoring& coloring) {
  if (coloring.by == ColorBy::island) return island_colors(snapshot, style);
  std::vector<Color> colors;
  for (const SnapshotBox& box : snapshot.boxes)
    colors.push_back(body_color(style, box));
  if (coloring.by == ColorBy::body) return colors;
  const std::vector<double> values = values_of(snapshot, coloring.by);
  const double top = coloring.top > 0.0 ? coloring.top : largest_of_cubes(snapshot, values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!snapshot.boxes[i].fixed) colors[i] = scale_color(style, top > 0.0 ? values[i] / top : 0.0);
  }
  return colors;
}

}  // namespace wuerfel
