// Single values of a sweep file.
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/exit_code.h"
#include "app/cli/picture_values.h"
#include "app/sweep/sweep_entries.h"
#include "core/scene/suggestion.h"

namespace wuerfel {

namespace {

[[noreturn]] void fail_type(const Spot& spot, std::string_view wanted) {
  spot.fail(fmt::format("must be {}, not {}", wanted, describe_value(spot.value)));
}

const Value::Array& array_at(const Spot& spot, std::string_view wanted) {
  const auto* items = std::get_if<Value::Array>(&spot.value.data);
  if (items == nullptr) fail_type(spot, wanted);
  return *items;
}

Spot item_spot(const Spot& spot, const Value::Array& items, std::size_t i) {
  return {spot.source, items[i], spot.table, spot.key, static_cast<int>(i) + 1};
}

std::string text_at(const Spot& spot) {
  const auto* text = std::get_if<std::string>(&spot.value.data);
  if (text == nullptr) fail_type(spot, "a text");
  return *text;
}

/// A value as JSON and TOML both write it; nothing for tables and dates.
struct ValueText {
  std::optional<std::string> operator()(bool value) const { return value ? "true" : "false"; }
  std::optional<std::string> operator()(std::int64_t value) const {
    return fmt::format("{}", value);
  }
  std::optional<std::string> operator()(double value) const {
    if (!std::isfinite(value)) return std::nullopt;
    return fmt::format("{}", value);
  }
  std::optional<std::string> operator()(const std::string& text) const {
    return nlohmann::json(text).dump();
  }
  std::optional<std::string> operator()(const Value::Array& items) const {
    std::string list;
    for (const Value& item : items) {
      const std::optional<std::string> text = std::visit(*this, item.data);
      if (!text) return std::nullopt;
      list += (list.empty() ? "" : ",") + *text;
    }
    return "[" + list + "]";
  }
  std::optional<std::string> operator()(const Value::Table& /*table*/) const {
    return std::nullopt;
  }
  std::optional<std::string> operator()(const ForeignValue& /*value*/) const {
    return std::nullopt;
  }
};

/// What a reader of the command line makes of a text, with its complaint put at the spot.
template <class Parse>
auto parsed_at(const Spot& spot, Parse parse) {
  const std::string text = text_at(spot);
  try {
    return parse(text);
  } catch (const UsageError& error) {
    spot.fail(error.what());
  }
}

}  // namespace

std::string_view to_string(Sampling sampling) {
  switch (sampling) {
    case Sampling::random:
      return "random";
    case Sampling::latin:
      return "latin";
    case Sampling::grid:
      return "grid";
  }
  return "?";
}

std::string_view to_string(Mask mask) {
  switch (mask) {
    case Mask::instance:
      return "instance";
    case Mask::violation:
      return "violation";
  }
  return "?";
}

void refuse_word(const Spot& spot,
                 const std::string& word,
                 const std::vector<std::string_view>& known) {
  spot.fail(fmt::format("\"{}\" is unknown{}", word, suggestion(word, known)));
}

std::vector<std::string> words_of(const Spot& spot) {
  const Value::Array& items = array_at(spot, "a list of words");
  std::vector<std::string> words;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Spot item = item_spot(spot, items, i);
    const std::string word = text_at(item);
    // Columns and files of one name would be told apart by nobody.
    if (std::ranges::count(words, word) > 0) item.fail(fmt::format("\"{}\" stands twice", word));
    words.push_back(word);
  }
  return words;
}

void read(const Spot& spot, const Limits& limits, std::vector<double>& target) {
  const Value::Array& items = array_at(spot, "a list of numbers");
  target.resize(items.size());
  for (std::size_t i = 0; i < items.size(); ++i)
    read(item_spot(spot, items, i), limits, target[i]);
}

void read(const Spot& spot, const Limits& limits, NumberInterval& target) {
  if (array_at(spot, "two numbers").size() != 2) fail_type(spot, "two numbers");
  std::vector<double> numbers;
  read(spot, limits, numbers);
  target.ends = {numbers[0], numbers[1]};
}

void read(const Spot& spot, const Limits& /*limits*/, WholeInterval& target) {
  const Value::Array& items = array_at(spot, "two whole numbers [low, high]");
  if (items.size() != 2) fail_type(spot, "two whole numbers [low, high]");
  constexpr Limits exact{-9'007'199'254'740'992.0, 9'007'199'254'740'992.0};
  read(item_spot(spot, items, 0), exact, target.low);
  read(item_spot(spot, items, 1), exact, target.high);
  if (target.low > target.high) spot.fail("must be [low, high] with low <= high");
}

void read(const Spot& spot, const Limits& /*limits*/, ValueList& target) {
  const Value::Array& items = array_at(spot, "a list of values");
  target.texts.clear();
  if (items.empty()) spot.fail("must not be empty");
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::optional<std::string> text = std::visit(ValueText{}, items[i].data);
    if (!text)
      fail_type(item_spot(spot, items, i), "a number, a text, true, false or a list of them");
    target.texts.push_back(*text);
  }
}

void read(const Spot& spot, const Limits& limits, RateChoice& target) {
  constexpr double usual = 30.0;  // per second
  if (const auto* wanted = std::get_if<bool>(&spot.value.data)) {
    target.fps = *wanted ? std::optional(usual) : std::nullopt;
    return;
  }
  const auto* table = std::get_if<Value::Table>(&spot.value.data);
  if (table == nullptr) fail_type(spot, "true, false or { fps = 30 }");
  target.fps = usual;
  const std::string path = spot.path();
  for (const Member& member : *table) {
    const Spot at{spot.source, member.value, path, member.key};
    if (member.key == "fps") {
      read(at, limits, *target.fps);
    } else if (member.key == "format" && spot.key == "states") {
      if (text_at(at) != "npy") at.fail("there is \"npy\" alone");
    } else {
      spot.source.fail(member.place, path,
                       fmt::format("unknown key \"{}\"; there is fps", member.key));
    }
  }
}

void read(const Spot& spot, const Limits& /*limits*/, TemplateChoice& target) {
  if (std::holds_alternative<Value::Table>(spot.value.data)) {
    target.table = &spot.value;
  } else if (std::holds_alternative<std::string>(spot.value.data)) {
    read(spot, {1.0, 4096.0}, target.path);
  } else {
    fail_type(spot, "a scene file or a table");
  }
}

void read(const Spot& spot, const Limits& limits, PixelSize& target) {
  std::vector<double> numbers;
  read(spot, limits, numbers);
  if (numbers.size() != 2 || numbers[0] != std::floor(numbers[0])
      || numbers[1] != std::floor(numbers[1]))
    fail_type(spot, "two whole numbers [width, height]");
  target = {static_cast<int>(numbers[0]), static_cast<int>(numbers[1])};
}

void read(const Spot& spot, const Limits& /*limits*/, Layers& target) {
  target = parsed_at(spot, [](const std::string& text) { return parse_layers(text); });
}

void read(const Spot& spot, const Limits& /*limits*/, Theme& target) {
  target = parsed_at(spot, [](const std::string& text) { return parse_theme(text); });
}

void read(const Spot& spot, const Limits& /*limits*/, Sampling& target) {
  const std::string word = text_at(spot);
  for (const Sampling sampling : {Sampling::random, Sampling::latin, Sampling::grid}) {
    if (to_string(sampling) == word) {
      target = sampling;
      return;
    }
  }
  refuse_word(spot, word, {"random", "latin", "grid"});
}

}  // namespace wuerfel
