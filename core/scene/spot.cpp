#include "core/scene/spot.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/scene/suggestion.h"
#include "core/scene/table_reader.h"

namespace wuerfel {
namespace {

[[noreturn]] void fail_type(const Spot& spot, std::string_view wanted) {
  spot.fail(fmt::format("must be {}, not {}", wanted, describe_value(spot.value)));
}

/// The rule that `value` breaks, as the end of "must ...".
std::string rule(double value, const Limits& limits) {
  if (limits.min == limits.max) return fmt::format("be {:g}", limits.min);
  if (value < 0.0 && limits.min == 0.0) return "not be negative";
  if (value <= 0.0 && limits.min > 0.0) return "be greater than 0";
  return fmt::format("be between {:g} and {:g}", limits.min, limits.max);
}

void check_limits(const Spot& spot, const Limits& limits, double value) {
  if (value >= limits.min && value <= limits.max) return;
  spot.fail(fmt::format("must {}; it is {}", rule(value, limits), describe_value(spot.value)));
}

/// The items of an array of `size` numbers, described as `wanted`.
const Value::Array& items_of(const Spot& spot, std::size_t size, std::string_view wanted) {
  const auto* items = std::get_if<Value::Array>(&spot.value.data);
  if (items == nullptr || items->size() != size) fail_type(spot, wanted);
  return *items;
}

Spot item_spot(const Spot& spot, const Value::Array& items, std::size_t i) {
  return {spot.source, items[i], spot.table, spot.key, static_cast<int>(i) + 1};
}

/// Characters that would break a line of output or a picture.
bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20U || c == '\x7f'; }

}  // namespace

std::string Spot::path() const {
  std::string path = table.empty() ? std::string(key) : fmt::format("{}.{}", table, key);
  if (element > 0) path += fmt::format("[{}]", element);
  return path;
}

void Spot::fail(const std::string& message) const { source.fail(value.place, path(), message); }

void read(const Spot& spot, const Limits& limits, double& target) {
  if (const auto* integer = std::get_if<std::int64_t>(&spot.value.data)) {
    target = static_cast<double>(*integer);
  } else if (const auto* number = std::get_if<double>(&spot.value.data)) {
    target = *number;
  } else {
    fail_type(spot, "a number");
  }
  if (!std::isfinite(target)) fail_type(spot, "a finite number");
  check_limits(spot, limits, target);
}

void read(const Spot& spot, const Limits& limits, std::int64_t& target) {
  if (const auto* integer = std::get_if<std::int64_t>(&spot.value.data)) {
    check_limits(spot, limits, static_cast<double>(*integer));
    target = *integer;
    return;
  }
  // JSON does not tell 5.0 from 5.
  const auto* number = std::get_if<double>(&spot.value.data);
  if (number == nullptr || *number != std::floor(*number)) fail_type(spot, "a whole number");
  check_limits(spot, limits, *number);
  target = static_cast<std::int64_t>(*number);
}

void read(const Spot& spot, const Limits& limits, std::string& target) {
  const auto* text = std::get_if<std::string>(&spot.value.data);
  if (text == nullptr) fail_type(spot, "a text");
  const auto characters = std::count_if(text->begin(), text->end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
  });
  if (static_cast<double>(characters) < limits.min) spot.fail("must not be empty");
  if (static_cast<double>(characters) > limits.max) {
    spot.fail(fmt::format("has {} characters; at most {} are allowed", characters, limits.max));
  }
  if (std::any_of(text->begin(), text->end(), is_control)) {
    spot.fail("must not hold line breaks or other control characters");
  }
  target = *text;
}

void read(const Spot& spot, const Limits& limits, Vec2& target) {
  const Value::Array& items = items_of(spot, 2, "two numbers [x, y]");
  read(item_spot(spot, items, 0), limits, target.x());
  read(item_spot(spot, items, 1), limits, target.y());
}

void read(const Spot& spot, const Limits& limits, Size& target) {
  if (const auto* items = std::get_if<Value::Array>(&spot.value.data)) {
    if (items->size() != 2) fail_type(spot, "a number or two numbers [width, height]");
    read(spot, limits, target.extent);
    return;
  }
  double side = 0.0;
  read(spot, limits, side);
  target.extent = {side, side};
}

void read(const Spot& spot, const Limits& limits, Region& target) {
  const Value::Array& items = items_of(spot, 4, "four numbers [xmin, ymin, xmax, ymax]");
  read(item_spot(spot, items, 0), limits, target.low.x());
  read(item_spot(spot, items, 1), limits, target.low.y());
  read(item_spot(spot, items, 2), limits, target.high.x());
  read(item_spot(spot, items, 3), limits, target.high.y());
  if (target.low.x() >= target.high.x() || target.low.y() >= target.high.y()) {
    spot.fail("must be [xmin, ymin, xmax, ymax] with xmin < xmax and ymin < ymax");
  }
}

void read(const Spot& spot, const Limits& limits, std::array<std::string, 2>& target) {
  const Value::Array& items = items_of(spot, 2, "two names [a, b]");
  read(item_spot(spot, items, 0), limits, target[0]);
  read(item_spot(spot, items, 1), limits, target[1]);
}

int read_choice(const Spot& spot, std::span<const std::string_view> names) {
  const auto* text = std::get_if<std::string>(&spot.value.data);
  const auto found = text == nullptr ? names.end() : std::ranges::find(names, *text);
  if (found == names.end()) {
    const std::string first =
        fmt::format("\"{}\"", fmt::join(names.first(names.size() - 1), "\", \""));
    fail_type(spot, fmt::format("{} or \"{}\"", first, names.back()));
  }
  return static_cast<int>(found - names.begin());
}

void read(const Spot& spot, const Limits& /*limits*/, bool& target) {
  const auto* value = std::get_if<bool>(&spot.value.data);
  if (value == nullptr) fail_type(spot, "true or false");
  target = *value;
}

void read(const Spot& spot, const Limits& limits, PlaceEntry& target) {
  if (std::holds_alternative<std::string>(spot.value.data)) {
    return read(spot, limits::place, target.name);
  }
  if (std::holds_alternative<Value::Array>(spot.value.data)) {
    return read(spot, limits, target.at);
  }
  if (!std::holds_alternative<Value::Table>(spot.value.data)) {
    fail_type(spot, "\"BODY\", \"BODY.PART\", { body = .., at = [x, y] } or [x, y]");
  }
  TableReader reader(spot.source, spot.value, spot.path());
  reader.required("body", target.name, limits::name, "");
  reader.required("at", target.at, limits, "");
  reader.finish();
  target.in_frame = true;
}

void read(const Spot& spot, const Limits& /*limits*/, Rgb& target) {
  const auto* text = std::get_if<std::string>(&spot.value.data);
  const std::optional<Rgb> color = text == nullptr ? std::nullopt : parse_color(*text);
  if (!color) {
    spot.fail(fmt::format(
        "must be \"#rrggbb\" or the name of a colour, not {}{}", describe_value(spot.value),
        text == nullptr ? "" : suggestion(*text, okabe_ito(), &NamedColor::name)));
  }
  target = *color;
}

}  // namespace wuerfel
