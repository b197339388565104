/// Columns of labels: what a sweep can measure of a case.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace wuerfel {

/// Of the scene at rest, as `check` has it.
enum class CheckColumn {
  verdict,   ///< stands, falls, moves or undecided
  contacts,  ///< how many there are
  /// Least shift of a cube's weight that changes the verdict, as a share of its smaller side;
  /// negative where the scene falls (`check --margin shift`).
  margin,
  weakest,  ///< the cube of that shift
  causes,   ///< the smallest part that falls by itself: its cubes, joined by +
};

/// Of a run to the end.
enum class RunColumn {
  time_of_fall,      ///< s, when a cube first was a tenth of its smaller side away from its start
  moved,             ///< how many cubes have moved by more than rounding
  at_rest,           ///< whether all stand still in the end, certified
  final_height,      ///< m, of the highest corner or point mass in the end
  first_event,       ///< its kind
  first_event_time,  ///< s
  events,            ///< how many there were
};

std::string_view to_string(CheckColumn column);
std::string_view to_string(RunColumn column);

/// monostate: there is none (nobody fell, nothing happened).
using Label = std::variant<std::monostate, bool, std::int64_t, double, std::string>;
using LabelRow = std::vector<std::pair<std::string, Label>>;

}  // namespace wuerfel
