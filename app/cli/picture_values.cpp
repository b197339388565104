#include "app/cli/picture_values.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "app/cli/argument.h"
#include "app/cli/choice.h"
#include "core/scene/suggestion.h"

namespace wuerfel {

namespace {

constexpr int most_frames_a_side = 1024;  // 16 pixels each in the largest picture

template <typename Enum>
Enum find_name(std::string_view kind, std::string_view name) {
  const std::vector<std::string> names = choices<Enum>();
  const auto found = std::ranges::find(names, name);
  if (found != names.end()) return static_cast<Enum>(found - names.begin());
  throw UsageError(fmt::format("unknown {} '{}'{}", kind, name, suggestion(name, names)));
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace

Theme parse_theme(std::string_view text) { return find_name<Theme>("theme", text); }

namespace {

/// Names with commas between them, or none at all; blanks beside the commas don't matter.
template <typename Enum>
EnumSet<Enum> parse_set(std::string_view kind, std::string_view text) {
  EnumSet<Enum> set;
  if (trimmed(text).empty()) return set;
  for (const std::string& part : split_list(text)) {
    const std::string_view name = trimmed(part);
    if (name.empty()) {
      throw UsageError(
          fmt::format("'{}' has a comma too many: beside it stands no {}", text, kind));
    }
    set.insert(find_name<Enum>(kind, name));
  }
  return set;
}

}  // namespace

Layers parse_layers(std::string_view text) { return parse_set<Layer>("layer", text); }

Legend parse_legend(std::string_view text) {
  return parse_set<LegendEntry>("entry of the legend", text);
}

StripGrid parse_strip(std::string_view text) {
  StripGrid grid;
  const char* const end = text.data() + text.size();
  const auto [middle, error] = std::from_chars(text.data(), end, grid.columns);
  if (error == std::errc{} && middle != end && *middle == 'x') {
    const auto [last, second_error] = std::from_chars(middle + 1, end, grid.rows);
    const auto possible = [](int count) { return count > 0 && count <= most_frames_a_side; };
    if (second_error == std::errc{} && last == end && possible(grid.columns) && possible(grid.rows))
      return grid;
  }
  throw UsageError(fmt::format("'{}' is not a film strip: use COLUMNSxROWS such as 4x2", text));
}

void require_scale(std::string_view name, double scale) {
  constexpr double smallest = 0.01;  // lines of a hundredth of a pixel
  constexpr double largest = 8.0;    // text of 150 px
  if (!(scale >= smallest && scale <= largest)) {
    throw UsageError(
        fmt::format("{}: {} is not between {} and {}", name, scale, smallest, largest));
  }
}

WorldWindow parse_window(std::string_view text) {
  std::array<double, 3> values{};
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (double& value : values) {
    const auto [next, error] = std::from_chars(at, end, value);
    const bool separated = &value == &values.back() ? next == end : next != end && *next == ',';
    if (error != std::errc{} || !separated) {
      throw UsageError(fmt::format(
          "'{}' is not a view: use fit, x,y,width in metres such as 0,2.5,8, or follow:NAME",
          text));
    }
    at = next + 1;
  }
  if (!(values[2] > 0.0) || !std::ranges::all_of(values, [](double v) { return std::isfinite(v); }))
    throw UsageError("a view needs a finite centre and a width greater than 0 m");
  return {Vec2(values[0], values[1]), values[2]};
}

}  // namespace wuerfel
