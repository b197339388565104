#include "app/sweep/case.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/exit_code.h"
#include "app/sweep/digest.h"
#include "core/scene/json_string.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t id_digits = 16;

// 7 and 7.0 are one value.
bool same_value(const std::string& a, const std::string& b) {
  return Json::parse(a) == Json::parse(b);
}

bool is_held_out(const Sweep& sweep, const HeldOut& held_out, const Case& one) {
  const auto variable = std::ranges::find(sweep.variables, held_out.key, &Variable::key);
  const std::string& value = one.values.at(variable - sweep.variables.begin());
  return std::ranges::any_of(held_out.values,
                             [&](const std::string& other) { return same_value(value, other); });
}

// Uniform in [0, 1), by the name.
double position(const std::string& id) {
  std::uint64_t bits = 0;
  std::from_chars(id.data(), id.data() + id.size(), bits, id_digits);
  return static_cast<double>(bits >> 11U) * 0x1p-53;
}

/// Goes through a line that `line_of` wrote, whose values are JSON. Throws UsageError where it is
/// another one.
class LineReader {
 public:
  explicit LineReader(std::string_view line) : line_(line), rest_(line) {}

  void pass(std::string_view expected) {
    if (!rest_.starts_with(expected)) fail();
    rest_.remove_prefix(expected.size());
  }
  std::string_view up_to(char end) { return take(rest_.find(end)); }
  /// Up to the comma or bracket behind it.
  std::string_view value() {
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      const char c = rest_[i];
      if (c == '\\') {
        ++i;
      } else if (c == '"') {
        quoted = !quoted;
      } else if (!quoted) {
        if (depth == 0 && (c == ',' || c == '}')) return take(i);
        depth += (c == '[' || c == '{') - (c == ']' || c == '}');
      }
    }
    fail();
  }

 private:
  std::string_view take(std::size_t length) {
    if (length >= rest_.size()) fail();
    const std::string_view taken = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return taken;
  }
  [[noreturn]] void fail() const {
    throw UsageError(
        fmt::format("the manifest has a line that is no case: {}", line_.substr(0, 80)));
  }

  std::string_view line_;
  std::string_view rest_;
};

/// What a message about a value of a normal distribution without ends lacks.
std::string_view remedy(const Sweep& sweep, std::string_view message) {
  for (const Variable& variable : sweep.variables) {
    const auto* normal = std::get_if<Normal>(&variable.distribution);
    if (normal != nullptr && !normal->clip && message.starts_with(variable.origin + ": "))
      return "; normal has no ends where clip = [low, high] sets none";
  }
  return "";
}

}  // namespace

Scene scene_of(const Sweep& sweep, const std::vector<std::string>& values) {
  std::vector<std::string> origins;
  for (const Variable& variable : sweep.variables)
    origins.insert(origins.end(), variable.keys.size(), variable.origin);
  try {
    return parse_scene(sweep.scene.text, sweep.scene.name, overrides_of(sweep, values), origins);
  } catch (const OverlapError&) {
    throw;
  } catch (const SceneError& error) {
    const std::string_view more = remedy(sweep, error.what());
    if (more.empty()) throw;
    throw SceneError(fmt::format("{}{}", error.what(), more));
  }
}

std::string case_id(const Sweep& sweep, const Scene& scene) {
  return Sha256().add(sweep.name).add("\n").add(normalised_scene(scene)).hex().substr(0, id_digits);
}

std::string split_of(const Sweep& sweep, const Case& one) {
  for (const HeldOut& held_out : sweep.split.held_out)
    if (is_held_out(sweep, held_out, one)) return "test_ood";
  double rest = position(one.id);
  for (const auto& [name, share] : sweep.split.shares) {
    if (rest < share) return name;
    rest -= share;
  }
  return sweep.split.shares.front().first;  // by rounding
}

std::string values_json(const Sweep& sweep, const Case& one) {
  std::string values;
  for (std::size_t v = 0; v < one.values.size(); ++v) {
    values += v == 0 ? '{' : ',';
    values += json_string(sweep.variables[v].key) + ':' + one.values[v];
  }
  return values + '}';
}

std::string line_of(const Sweep& sweep, const Case& one) {
  return fmt::format(R"({{"case":{},"id":"{}","split":"{}","values":{}}})", one.number, one.id,
                     one.split, values_json(sweep, one));
}

Case case_of(const Sweep& sweep, std::string_view line) {
  LineReader reader(line);
  Case one;
  reader.pass(R"({"case":)");
  const std::string_view number = reader.value();
  std::from_chars(number.data(), number.data() + number.size(), one.number);
  reader.pass(R"(,"id":")");
  one.id = reader.up_to('"');
  reader.pass(R"(","split":")");
  one.split = reader.up_to('"');
  reader.pass(R"(","values":{)");
  for (const Variable& variable : sweep.variables) {
    if (!one.values.empty()) reader.pass(",");
    reader.pass(json_string(variable.key) + ":");
    one.values.emplace_back(reader.value());
  }
  reader.pass("}}");
  return one;
}

}  // namespace wuerfel
